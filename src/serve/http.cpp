#include "serve/http.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "base/errors.h"
#include "serve/mistake_json.h"
#include "serve/refusal.h"

namespace knitmech::serve {

void put(httplib::Response& answer, std::shared_ptr<const std::string> content, const std::string& type) {
  if (content->empty()) {
    answer.set_content("", type);
    return;
  }
  const std::size_t length = content->size();
  answer.set_content_provider(
      length, type, [content = std::move(content)](std::size_t offset, std::size_t n_bytes, httplib::DataSink& sink) {
        return sink.write(content->data() + offset, n_bytes);
      });
}

void put(httplib::Response& answer, std::string content, const std::string& type) {
  put(answer, std::make_shared<const std::string>(std::move(content)), type);
}

void put_json(httplib::Response& answer, std::string content) {
  put(answer, std::move(content), "application/json");
}

void put_mistake(httplib::Response& answer, int status, const std::exception& error) {
  answer.status = status;
  const nlohmann::ordered_json body{{"error", mistake_json(error)}};
  put_json(answer, body.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

httplib::Server::Handler answering(std::function<void(const httplib::Request&, httplib::Response&)> handler) {
  return [handler = std::move(handler)](const httplib::Request& request, httplib::Response& answer) {
    try {
      handler(request, answer);
    } catch (const Refusal& refusal) {
      put_mistake(answer, refusal.status(), refusal);
    } catch (const InputError& error) {
      put_mistake(answer, 400, error);
    } catch (const nlohmann::json::exception&) {
      put_mistake(answer, 400, InputError("the request is not the JSON that it should be"));
    } catch (const std::bad_alloc&) {
      put_mistake(answer, 400, InputError("the memory of this computer is too small for that"));
    } catch (const std::exception& error) {
      put_mistake(answer, 500, error);
    }
  };
}

}  // namespace knitmech::serve
