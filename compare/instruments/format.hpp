// What every format's reader has: what it is given, what it gives, and how it is told from the others.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compare/instruments/archive.hpp"
#include "compare/results/recording.hpp"

namespace validate {

/// What the caller knows, in place of what a file lacks. Where the detector's signal is a current, the sensitivity is
/// in m/A.
struct Calibration {
  std::optional<double> spring_constant_N_per_m, sensitivity;
};

/// The content of a file, or of a member of an archive that holds ordinary files.
struct FileContent {
  std::string name;                 ///< for messages, with the archive's and the member's
  std::string_view bytes;           ///< all of it; the beginning alone where `archive` or `path` stand for it
  std::filesystem::path path = {};  ///< where the file itself is; empty for a member
  std::shared_ptr<const Archive> archive = {};  ///< of a zip archive
};

/// The curves of a file, read one at a time: a map has thousands.
class Recordings {
 public:
  virtual ~Recordings() = default;
  virtual std::size_t size() const = 0;

  /// Throws Error (bad input) with file, line or offset and what is allowed.
  virtual Recording read(std::size_t i) const = 0;
};

/// Curves that are in memory already.
class ReadyRecordings : public Recordings {
 public:
  explicit ReadyRecordings(std::vector<Recording> recordings) : recordings_(std::move(recordings)) {}
  std::size_t size() const override { return recordings_.size(); }
  Recording read(std::size_t i) const override { return recordings_.at(i); }

 private:
  std::vector<Recording> recordings_;
};

/// One format of the list.
struct InstrumentFormat {
  std::string_view name;     ///< as `--help` says it
  std::string_view example;  ///< how its files are usually named
  bool (*recognises)(const FileContent& file);
  std::unique_ptr<Recordings> (*open)(const FileContent& file, const Calibration& calibration);
};

/// Every format, in the order in which they are tried: the one that takes any table comes last.
std::span<const InstrumentFormat> instrument_formats();

/// Opens a file as the first format of the list that recognises its content. A zip archive of ordinary files gives the
/// curves of all of them, in order of their names. Throws Error: bad input where no format does, or with what is wrong
/// and where; file failed if it cannot be read.
std::unique_ptr<Recordings> open_recordings(const std::filesystem::path& file, const Calibration& calibration);

}  // namespace validate
