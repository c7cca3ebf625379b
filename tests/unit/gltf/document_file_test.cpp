#include "src/results/gltf/document_file.hpp"

#include <gtest/gtest.h>

namespace rubicon::gltf {
namespace {

Document document(const std::string& binary) {
  Document made;
  made.json["asset"] = {{"version", "2.0"}};
  made.json["buffers"] = Json::array({{{"byteLength", binary.size()}}});
  made.binary = binary;
  return made;
}

std::string uri(const std::string& binary) {
  return Json::parse(gltf_text(document(binary)))["buffers"][0]["uri"];
}

TEST(DocumentFile, WritesBase64) {  // RFC 4648, section 10
  const std::string head = "data:application/octet-stream;base64,";
  EXPECT_EQ(uri("f"), head + "Zg==");
  EXPECT_EQ(uri("fo"), head + "Zm8=");
  EXPECT_EQ(uri("foo"), head + "Zm9v");
  EXPECT_EQ(uri("foobar"), head + "Zm9vYmFy");
  EXPECT_EQ(uri("\xff\xfe\xfd"), head + "//79");
}

TEST(DocumentFile, PadsTheChunksOfABinaryFile) {
  for (const std::string binary : {"1234", "12345", "1234567"}) {
    const std::string bytes = glb_bytes(document(binary));
    EXPECT_EQ(bytes.size() % 4, 0U);
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_NE(bytes.find(std::string("BIN\0", 4) + binary), std::string::npos);
  }
}

TEST(DocumentFile, WritesNamesThatAreNoUtf8) {
  Document made = document("");
  made.json["asset"]["extras"] = "a\xff";
  EXPECT_EQ(Json::parse(gltf_text(made))["asset"]["extras"], "a\uFFFD");
}

}  // namespace
}  // namespace rubicon::gltf
