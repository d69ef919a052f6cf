#pragma once

#include <cxxabi.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <typeinfo>
#include <vector>

#include "base/left_out.h"

namespace knitmech::test {

/// An archive that writes nothing: it looks whether serialize() of an object names every member, saved or left out, and
/// the same for the objects in it. A member that is not named leaves a gap between those that are, wider than their
/// alignment asks for.
class MemberCheck {
 public:
  using is_loading = std::false_type;

  /// Names of the classes with a member that is not named.
  template <class Object>
  static std::vector<std::string> classes_with_gaps(Object& object) {
    MemberCheck check;
    check.look_into(object);
    std::sort(check.with_gaps_.begin(), check.with_gaps_.end());
    check.with_gaps_.erase(std::unique(check.with_gaps_.begin(), check.with_gaps_.end()), check.with_gaps_.end());
    return check.with_gaps_;
  }

  template <class... Members>
  void operator()(Members&&... members) {
    (add(members), ...);
  }

 private:
  struct Place {
    std::uintptr_t begin, end;
    std::size_t alignment;
  };

  template <class Object>
  static constexpr bool kHasMembers = requires(Object& object, MemberCheck& archive) {
    object.serialize(archive);
  };

  template <class Member>
  void add(Member& member) {
    note(member);
    look_into(member);
  }
  template <class... Members>
  void add(base::LeftOut<Members...>& left_out) {
    std::apply([this](const auto*... member) { (this->note(*member), ...); }, left_out.members);
  }
  template <class Member>
  void note(const Member& member) {
    const auto begin = reinterpret_cast<std::uintptr_t>(std::addressof(member));
    places_.push_back({begin, begin + sizeof(Member), alignof(Member)});
  }

  template <class Object>
  void look_into(Object& object) {
    if constexpr (kHasMembers<Object>) {
      MemberCheck inner;
      object.serialize(inner);
      with_gaps_.insert(with_gaps_.end(), inner.with_gaps_.begin(), inner.with_gaps_.end());
      if (inner.has_gap(reinterpret_cast<std::uintptr_t>(&object), sizeof(Object), alignof(Object))) {
        with_gaps_.push_back(name_of(typeid(Object)));
      }
    }
  }
  template <class Element>
  void look_into(std::vector<Element>& /*elements*/) {
    Element element{};
    look_into(element);
  }
  template <class Element, std::size_t n>
  void look_into(std::array<Element, n>& elements) {
    look_into(elements.front());
  }
  template <class Value>
  void look_into(std::optional<Value>& /*value*/) {
    Value value{};
    look_into(value);
  }

  /// A member that is a reference is seen where it refers to, outside the object; it takes up a pointer inside.
  [[nodiscard]] bool has_gap(std::uintptr_t begin, std::size_t size, std::size_t alignment) {
    std::sort(places_.begin(), places_.end(), [](const Place& a, const Place& b) { return a.begin < b.begin; });
    std::size_t unnamed = 0;
    std::size_t referred = 0;
    std::uintptr_t at = begin;
    for (const Place& place : places_) {
      if (place.begin < begin || place.begin >= begin + size) {
        referred += sizeof(void*);
        continue;
      }
      if (place.begin > at && place.begin - at >= place.alignment) unnamed += place.begin - at;
      at = std::max(at, place.end);
    }
    if (begin + size - at >= alignment) unnamed += begin + size - at;
    return unnamed > referred;
  }

  static std::string name_of(const std::type_info& type) {
    const std::unique_ptr<char, void (*)(void*)> name(abi::__cxa_demangle(type.name(), nullptr, nullptr, nullptr),
                                                      std::free);
    return name ? name.get() : type.name();
  }

  std::vector<Place> places_;
  std::vector<std::string> with_gaps_;
};

}  // namespace knitmech::test
