// Named files in one: a zip archive, or what a test puts together.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace validate {

class Archive {
 public:
  virtual ~Archive() = default;

  /// Of the members that are files, in the archive's order, each once.
  virtual const std::vector<std::string>& names() const = 0;
  virtual bool has(const std::string& name) const = 0;

  /// Content of a member. Throws Error (bad input) that names the archive and the member: it is not there, is damaged
  /// or encrypted, or claims to be larger than its bytes in the archive can hold.
  virtual std::string read(const std::string& name) const = 0;
};

/// Members kept in memory.
class ArchiveInMemory : public Archive {
 public:
  explicit ArchiveInMemory(std::map<std::string, std::string> members);
  const std::vector<std::string>& names() const override { return names_; }
  bool has(const std::string& name) const override { return members_.contains(name); }
  std::string read(const std::string& name) const override;

 private:
  std::map<std::string, std::string> members_;
  std::vector<std::string> names_;
};

/// Whether a file begins as zip archives do.
bool looks_like_zip(std::string_view first_bytes);

/// Throws Error (bad input) where the archive cannot be opened.
std::unique_ptr<Archive> open_zip(const std::filesystem::path& file);

}  // namespace validate
