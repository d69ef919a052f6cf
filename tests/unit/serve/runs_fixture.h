#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "results/atomic_file.h"
#include "serve/runs.h"

namespace knitmech::serve {

using Json = nlohmann::json;

/// Pictures take longer than all else here.
inline constexpr RunsOptions kQuick{.pictures = false};

/// 2 x 2 stitches. The last two say how many steps the run takes.
inline std::string case_text(const std::string& strain = "0.02", const std::string& frames_at = "[0.01, 0.02]",
                             const std::string& mass_scaling = "100", const std::string& speed = "20 mm/s") {
  return R"(title = "Small"
[loop]
height = "7 mm"
width = "3.9 mm"
head_flat = "0.2 mm"
head_radius = "1.1 mm"
foot_flat = "0.2 mm"
foot_radius = "1 mm"
out_of_plane = "0.02 /mm"
[fabric]
wales = 2
courses = 2
course_spacing = "5 mm"
elements_per_erc = 8
[yarn]
diameter = "0.12 mm"
density = "1140 kg/m^3"
youngs_modulus = "1700 MPa"
poissons_ratio = 0.39
[contact]
friction = 0.1
[test]
kind = "wale-tension"
ramp = "5 ms"
strain = )" +
         strain + "\nspeed = \"" + speed + "\"\n[solver]\nmass_scaling = " + mass_scaling +
         "\n[output]\nhistory_points = 400\nframes_at = " + frames_at + "\n";
}

/// A test that takes many seconds, so that it is surely under way when it is looked at; rows come fast.
inline std::string long_case_text() {
  std::string text = case_text("0.3", "[0.1]", "1", "5 mm/s");
  return text.replace(text.find("400"), 3, "9000");
}

/// A blob read as the page reads it.
class ReadBlob {
 public:
  explicit ReadBlob(std::string bytes) : bytes_(std::move(bytes)) {
    std::uint32_t length = 0;
    std::memcpy(&length, bytes_.data(), sizeof length);
    start_ = sizeof length + length;
    head_ = Json::parse(bytes_.substr(sizeof length, length));
  }

  [[nodiscard]] const Json& head() const { return head_; }

  template <typename Number>
  [[nodiscard]] std::vector<Number> numbers(const std::string& name) const {
    const Json& place = head_.at("arrays").at(name);
    EXPECT_EQ(place.at("type"), (std::is_same_v<Number, float> ? "f32" : "i32"));
    std::vector<Number> all(place.at("length").get<std::size_t>());
    if (!all.empty()) {
      std::memcpy(all.data(), bytes_.data() + start_ + place.at("offset").get<std::size_t>(),
                  all.size() * sizeof(Number));
    }
    return all;
  }
  [[nodiscard]] std::vector<float> floats(const std::string& name) const { return numbers<float>(name); }
  [[nodiscard]] std::vector<std::int32_t> integers(const std::string& name) const {
    return numbers<std::int32_t>(name);
  }

 private:
  std::string bytes_;
  std::size_t start_ = 0;
  Json head_;
};

/// A folder for runs, which goes with the test.
class RunsTest : public testing::Test {
 protected:
  RunsTest() {
    std::string name = (std::filesystem::temp_directory_path() / "knitmech-runs-XXXXXX").string();
    top_ = mkdtemp(name.data());
    root_ = top_ / "runs";
  }
  ~RunsTest() override { std::filesystem::remove_all(top_); }

  /// Waits for something that comes sooner or later; the limit is for a program that is broken.
  static void wait_until(const char* what, const std::function<bool()>& holds) {
    const auto limit = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    while (!holds()) {
      if (std::chrono::steady_clock::now() > limit) throw std::runtime_error(std::string("waited in vain: ") + what);
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }

  static Json head(Runs& runs, const std::string& id) {
    for (const Json& one : Json::parse(runs.list_json())) {
      if (one.at("id") == id) return one;
    }
    return nullptr;
  }
  static std::string status(Runs& runs, const std::string& id) {
    const Json one = head(runs, id);
    return one.is_null() ? "" : one.at("status").get<std::string>();
  }
  static void wait_for_status(Runs& runs, const std::string& id, const std::string& wanted) {
    wait_until(wanted.c_str(), [&] { return status(runs, id) == wanted; });
  }
  /// Until the program has nothing more to do with it.
  static void wait_for_end(Runs& runs, const std::string& id) {
    wait_until("its end", [&] {
      const Json one = head(runs, id);
      return one.is_null() || !one.at("active").get<bool>();
    });
  }
  static Json history(Runs& runs, const std::string& id, std::size_t from = 0) {
    return Json::parse(runs.history_json(id, from));
  }
  static Json detail(Runs& runs, const std::string& id) { return Json::parse(runs.detail_json(id)); }
  static std::size_t n_rows(Runs& runs, const std::string& id) {
    return history(runs, id).at("columns").at("strain").size();
  }

  [[nodiscard]] std::string text_of(const std::string& id, const char* file) const {
    return results::read_file(root_ / id / file);
  }
  [[nodiscard]] std::size_t n_folders() const {
    if (!std::filesystem::exists(root_)) return 0;
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(root_), std::filesystem::directory_iterator()));
  }

  std::filesystem::path top_, root_;
};

}  // namespace knitmech::serve
