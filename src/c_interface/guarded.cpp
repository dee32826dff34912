// SPDX-License-Identifier: Apache-2.0
#include "c_interface/guarded.hpp"

#include <cstdlib>
#include <cstring>
#include <new>
#include <string>

#include "crossgrain/error.hpp"

namespace crossgrain {
namespace {

crossgrain_status status_of(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::kUsage:
      return CROSSGRAIN_USAGE;
    case ErrorKind::kInput:
      return CROSSGRAIN_INPUT;
    case ErrorKind::kOutput:
      return CROSSGRAIN_OUTPUT;
    case ErrorKind::kLimit:
      return CROSSGRAIN_LIMIT;
    case ErrorKind::kInterrupted:
      return CROSSGRAIN_INTERRUPTED;
  }
  return CROSSGRAIN_INTERNAL;
}

/// An error with its texts.
struct OwnedError : crossgrain_error {
  std::string its_sentence, its_remedy;
  Message message;

  OwnedError(crossgrain_status its_status, Message its_message)
      : crossgrain_error{},
        its_sentence(sentence_of(its_message)),
        its_remedy(words_of(its_message.remedy, its_message.remedy_number)),
        message(std::move(its_message)) {
    status = its_status;
    sentence = its_sentence.c_str();
    file = message.file.c_str();
    place = message.place.c_str();
    text = message.text.c_str();
    remedy = its_remedy.c_str();
    remedy_name = name_of(message.remedy);
  }
};

/// Returns the status, with an error of message() if there is memory for it.
template <class MessageOf>
crossgrain_status passed_on(crossgrain_status status, crossgrain_error** error,
                            const MessageOf& message) noexcept {
  if (error == nullptr) return status;
  try {
    *error = new OwnedError(status, message());
  } catch (...) {
    *error = nullptr;
  }
  return status;
}

}  // namespace

crossgrain_status status_of(const std::exception_ptr& exception, crossgrain_error** error) noexcept {
  const auto unexpected = [&](const char* text) {
    return passed_on(CROSSGRAIN_INTERNAL, error, [&] { return Message{{}, {}, text, Remedy::kReportModel}; });
  };
  try {
    if (exception) std::rethrow_exception(exception);
  } catch (const Error& its_error) {
    return passed_on(status_of(its_error.kind()), error, [&] { return its_error.message(); });
  } catch (const std::bad_alloc&) {
    return passed_on(CROSSGRAIN_LIMIT, error, [] {
      return Message{{}, {}, "out of memory", Remedy::kFreeMemory};
    });
  } catch (const std::exception& its_error) {
    return unexpected(its_error.what());
  } catch (...) {
  }
  return unexpected("unexpected failure");
}

void throw_missing(const char* name) {
  throw Error(ErrorKind::kUsage, std::string("the argument ") + name + " is NULL or too long");
}

Degree degree_of(int degree) {
  if (degree != 3 && degree != 4) throw Error(ErrorKind::kUsage, "the degree is 3 or 4");
  return static_cast<Degree>(degree);
}

int checked_threads(int threads) {
  if (threads < 0) throw Error(ErrorKind::kUsage, "the number of threads is 0 or more");
  return threads;
}

char* copy_of(const std::string& text) {
  auto* const copy = static_cast<char*>(std::malloc(text.size() + 1));
  if (copy == nullptr) throw std::bad_alloc();
  std::memcpy(copy, text.c_str(), text.size() + 1);
  return copy;
}

}  // namespace crossgrain

void crossgrain_error_free(crossgrain_error* error) {
  delete static_cast<crossgrain::OwnedError*>(error);
}

void crossgrain_text_free(char* text) {
  std::free(text);
}
