// A folder for intermediate files that goes when its owner does.
#pragma once

#include <filesystem>
#include <string>

namespace validate {

class TemporaryFolder {
 public:
  /// Below the system's temporary folder, `prefix` and six letters. Throws Error (file failed).
  explicit TemporaryFolder(const std::string& prefix);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  void keep() { kept_ = true; }

 private:
  std::filesystem::path path_;
  bool kept_ = false;
};

}  // namespace validate
