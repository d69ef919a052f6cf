#pragma once

// The only header that shows the HTTP library; three source files include it. Debian's library is built with these
// options, which its header must be told.
#define CPPHTTPLIB_OPENSSL_SUPPORT
#define CPPHTTPLIB_ZLIB_SUPPORT
#define CPPHTTPLIB_BROTLI_SUPPORT
#include <httplib.h>
#undef _res  // of <resolv.h>, which the library includes; Eigen has a variable of that name

#include <functional>
#include <memory>
#include <string>

namespace knitmech::serve {

/// Puts a content into an answer as it is: the library packs whatever else it sends, which takes seconds for a
/// megabyte.
void put(httplib::Response& answer, std::shared_ptr<const std::string> content, const std::string& type);
void put(httplib::Response& answer, std::string content, const std::string& type);
void put_json(httplib::Response& answer, std::string content);

/// The answer to a request that cannot be done: {"error": Mistake}.
void put_mistake(httplib::Response& answer, int status, const std::exception& error);

/// A handler whose errors become answers: Refusal with its status, InputError 400, FileError 500.
[[nodiscard]] httplib::Server::Handler answering(
    std::function<void(const httplib::Request&, httplib::Response&)> handler);

}  // namespace knitmech::serve
