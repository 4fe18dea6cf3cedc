// A folder for intermediate files that goes when its owner does.
#pragma once

#include <filesystem>
#include <string>

#include "compare/base/descriptor.hpp"

namespace validate {

class TemporaryFolder {
 public:
  /// Below the system's temporary folder, `prefix` and six letters. Removes those of this user's killed programs first.
  /// It is in use until this program and every one started meanwhile have ended. Throws Error (file failed).
  explicit TemporaryFolder(const std::string& prefix);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// For the user to look into; about a day.
  void keep();

 private:
  std::filesystem::path path_;
  Descriptor lock_;
  bool kept_ = false;
};

}  // namespace validate
