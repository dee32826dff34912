// SPDX-License-Identifier: Apache-2.0
#include "archives/xml_elements.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "archives/archive_errors.hpp"
#include "files/temporary_folder.hpp"

namespace crossgrain {
namespace {

const InputFile& any_file() {
  static const TemporaryFolder folder;
  static const InputFile file(folder.write("a.3mf", "a"));
  return file;
}

TEST(XmlElements, AreGivenWithNamespacesAndAttributes) {
  std::vector<std::string> found;
  read_xml(any_file(), "part",
           R"(<?xml version="1.0"?><a xmlns="u:a" xmlns:p="u:p" k="1" p:k="2 &lt; 3"><p:b/></a>)",
           {[&](const XmlElement& element) {
              found.push_back(std::string(element.space) + " " + std::string(element.name) + " " +
                              std::string(element.value("k")) + " " + std::string(element.value("k", "u:p")));
            },
            [&](std::string_view, std::string_view name) { found.push_back("/" + std::string(name)); }});
  EXPECT_EQ(found, (std::vector<std::string>{"u:a a 1 2 < 3", "u:p b  ", "/b", "/a"}));
}

TEST(XmlElements, OfMalformedTextAreAnErrorWithPartAndLine) {
  for (const char* text : {"<a>\n<b>\n</a>", "<a>\n\n", "", "<a>\n&unknown;</a>", "no XML"}) {
    const std::string message =
        input_error([&] { read_xml(any_file(), "part", text, {[](const auto&) {}}); });
    EXPECT_NE(message.find("'part', line "), std::string::npos) << message;
    EXPECT_NE(message.find("is no sound XML: "), std::string::npos) << message;
  }
}

TEST(XmlElements, OfADocumentWithATypeAreRefused) {
  const std::string message = input_error([] {
    read_xml(any_file(), "part", "<!DOCTYPE a [<!ENTITY b \"bb\"><!ENTITY c \"&b;&b;\">]>\n<a>&c;</a>",
             {[](const auto&) {}});
  });
  EXPECT_NE(message.find("declares the type of its document"), std::string::npos) << message;
}

TEST(XmlElements, PassOnWhatIsThrownAtOne) {
  int seen = 0;
  EXPECT_THROW(read_xml(any_file(), "part", "<a><b/><c/></a>", {[&](const XmlElement& element) {
                          ++seen;
                          if (element.name == "b") throw std::runtime_error("here");
                        }}),
               std::runtime_error);
  EXPECT_EQ(seen, 2);
}

}  // namespace
}  // namespace crossgrain
