// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_SequenceOfPrinters.hxx>
#include <iostream>
#include <streambuf>

namespace crossgrain {

/// As long as it lives, OpenCASCADE's messenger has no printers, and what is written to the standard streams
/// of C++ is lost: parts of OpenCASCADE write there past the messenger. Only one at a time.
class QuietOpenCascade {
 public:
  QuietOpenCascade() { Message::DefaultMessenger()->ChangePrinters().Clear(); }
  ~QuietOpenCascade() {
    std::cout.rdbuf(cout_);
    std::cerr.rdbuf(cerr_);
    std::clog.rdbuf(clog_);
    Message::DefaultMessenger()->ChangePrinters() = printers_;
  }
  QuietOpenCascade(const QuietOpenCascade&) = delete;
  QuietOpenCascade& operator=(const QuietOpenCascade&) = delete;

 private:
  struct Sink : std::streambuf {
    int_type overflow(int_type c) override { return traits_type::not_eof(c); }
  };

  Message_SequenceOfPrinters printers_ = Message::DefaultMessenger()->Printers();
  Sink sink_;
  std::streambuf* cout_ = std::cout.rdbuf(&sink_);
  std::streambuf* cerr_ = std::cerr.rdbuf(&sink_);
  std::streambuf* clog_ = std::clog.rdbuf(&sink_);
};

}  // namespace crossgrain
