#include "compare/instruments/archive.hpp"

#include <zip.h>

#include <algorithm>

#include "compare/base/errors.hpp"

namespace validate {
namespace {

/// No curve needs more, and deflate makes at most 1032 bytes of one.
constexpr zip_uint64_t largest_member = zip_uint64_t{1} << 30;
constexpr zip_uint64_t bytes_of_one = 1100;
constexpr std::size_t piece = std::size_t{1} << 16;

struct Discard {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseMember {
  void operator()(zip_file_t* member) const { zip_fclose(member); }
};

class Zip : public Archive {
 public:
  explicit Zip(const std::filesystem::path& file) : file_(file.string()), bytes_(std::filesystem::file_size(file)) {
    int code = 0;
    archive_.reset(zip_open(file.c_str(), ZIP_RDONLY, &code));
    if (!archive_) {
      zip_error_t error;
      zip_error_init_with_code(&error, code);
      const std::string reason = zip_error_strerror(&error);
      zip_error_fini(&error);
      throw bad_input("{}: is not a zip archive that can be opened: {}", file_, reason);
    }
    const zip_int64_t entries = zip_get_num_entries(archive_.get(), 0);
    for (zip_int64_t i = 0; i < entries; ++i) {
      const char* name = zip_get_name(archive_.get(), static_cast<zip_uint64_t>(i), ZIP_FL_ENC_GUESS);
      if (!name || std::string_view(name).ends_with('/')) continue;
      if (places_.emplace(name, static_cast<zip_uint64_t>(i)).second) names_.emplace_back(name);
    }
  }

  const std::vector<std::string>& names() const override { return names_; }
  bool has(const std::string& name) const override { return places_.contains(name); }

  std::string read(const std::string& name) const override {
    const auto place = places_.find(name);
    if (place == places_.end()) throw bad_input("{}: there is no member '{}' in the archive", file_, name);
    const zip_uint64_t size = checked_size(name, place->second);
    const std::unique_ptr<zip_file_t, CloseMember> member(zip_fopen_index(archive_.get(), place->second, 0));
    if (!member) throw bad_input("{}: member '{}': {}", file_, name, zip_strerror(archive_.get()));
    std::string content;
    while (content.size() < size) {
      const std::size_t before = content.size();
      content.resize(before + std::min<zip_uint64_t>(piece, size - before));
      const zip_int64_t got = zip_fread(member.get(), content.data() + before, content.size() - before);
      if (got < 0) throw bad_input("{}: member '{}' is damaged: {}", file_, name, zip_file_strerror(member.get()));
      content.resize(before + static_cast<std::size_t>(got));
      if (got == 0) throw bad_input("{}: member '{}' ends after {} of {} bytes", file_, name, content.size(), size);
    }
    char one_more = 0;  // the checksum is looked at when the end is read
    if (zip_fread(member.get(), &one_more, 1) != 0)
      throw bad_input("{}: member '{}' is damaged: {}", file_, name, zip_file_strerror(member.get()));
    return content;
  }

 private:
  zip_uint64_t checked_size(const std::string& name, zip_uint64_t place) const {
    zip_stat_t stat;
    zip_stat_init(&stat);
    constexpr zip_uint64_t needed = ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE;
    if (zip_stat_index(archive_.get(), place, 0, &stat) != 0 || (stat.valid & needed) != needed)
      throw bad_input("{}: member '{}' has no size", file_, name);
    if (stat.comp_size > bytes_ || stat.size > largest_member || stat.size / bytes_of_one > stat.comp_size)
      throw bad_input("{}: member '{}' claims {} bytes made of {}; an archive of {} bytes cannot hold it (at most {})",
                      file_, name, stat.size, stat.comp_size, bytes_, largest_member);
    return stat.size;
  }

  std::string file_;
  zip_uint64_t bytes_;
  std::unique_ptr<zip_t, Discard> archive_;
  std::map<std::string, zip_uint64_t> places_;
  std::vector<std::string> names_;
};

}  // namespace

ArchiveInMemory::ArchiveInMemory(std::map<std::string, std::string> members) : members_(std::move(members)) {
  for (const auto& [name, content] : members_) names_.push_back(name);
}

std::string ArchiveInMemory::read(const std::string& name) const {
  const auto found = members_.find(name);
  if (found == members_.end()) throw bad_input("there is no member '{}' in the archive", name);
  return found->second;
}

bool looks_like_zip(std::string_view first_bytes) {
  return first_bytes.starts_with("PK\x03\x04") || first_bytes.starts_with("PK\x05\x06");
}

std::unique_ptr<Archive> open_zip(const std::filesystem::path& file) { return std::make_unique<Zip>(file); }

}  // namespace validate
