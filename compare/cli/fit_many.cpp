#include "compare/cli/fit_many.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <fstream>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>

#include "compare/base/errors.hpp"
#include "compare/base/interrupt.hpp"
#include "compare/base/progress.hpp"
#include "compare/base/units.hpp"
#include "compare/documents/texts/many_csv.hpp"
#include "compare/fitting/curve_quality.hpp"
#include "compare/fitting/curve_row.hpp"
#include "compare/fitting/joint_fit.hpp"
#include "compare/fitting/measured_fit.hpp"
#include "compare/fitting/measured_points.hpp"
#include "compare/fitting/spread_mean.hpp"
#include "compare/process/many_cases.hpp"

namespace validate {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_in_full = 20;  ///< curves; of more only the rows are kept

/// The rows as they come, in a file that a later run goes on from.
class RowKeeper {
 public:
  void open(const fs::path& file, const FitFlags& flags) {
    std::string said = "#";
    describe(flags, [&](const Field& field, const auto& value) { said += fmt::format(" {}='{}'", field.name, value); });
    for (const std::string& name : flags.files) said += " " + name;
    if (flags.resume) read(file, said);
    out_.open(file, known_.empty() ? std::ios::trunc : std::ios::app);
    if (!out_) throw Error(ExitCode::file_failed, fmt::format("--out: {} cannot be written", file.string()));
    if (known_.empty()) out_ << said << '\n' << many_csv_header() << std::endl;
  }

  void remove(const fs::path& file) {
    out_.close();
    std::error_code ignored;
    fs::remove(file, ignored);
  }

  /// Of an earlier run.
  const CurveRow* find(const std::string& file, int index) const {
    const auto found = known_.find({file, index});
    return found == known_.end() ? nullptr : &found->second;
  }

  void keep(const CurveRow& row) {
    if (!out_.is_open()) return;
    const std::lock_guard lock(mutex_);
    out_ << many_csv_row(row) << std::endl;
  }

 private:
  void read(const fs::path& file, const std::string& said) {
    std::ifstream in(file);
    std::string line;
    if (!std::getline(in, line)) return;
    if (line != said)
      throw bad_input("--resume: {} was begun with other settings:\n  {}\nand now\n  {}", file.string(), line, said);
    std::getline(in, line);
    while (std::getline(in, line)) try {
        CurveRow row = many_csv_read(line);
        const std::pair key{row.file, row.index};
        known_.insert_or_assign(key, std::move(row));
      } catch (const std::invalid_argument&) {
        break;  // the line that a kill cut short
      }
  }

  std::ofstream out_;
  std::mutex mutex_;
  std::map<std::pair<std::string, int>, CurveRow> known_;
};

/// A curve of a file by its place in it.
struct Place {
  std::size_t file = 0, curve = 0;
};

class ManyFits {
 public:
  ManyFits(const FitFlags& flags, const std::optional<PotentialCard>& card, const std::optional<fs::path>& partial,
           Result& result)
      : flags_(flags), card_(card), partial_(partial), result_(result), progress_(flags.quiet) {}

  void run() {
    open_all();
    in_full_ = places_.size() <= most_in_full;
    if (!in_full_ && partial_) keeper_.open(*partial_, flags_);
    rows_.resize(places_.size());
    curves_.resize(places_.size());
    failures_.resize(places_.size());
    on_all_cores(places_.size(), [this](std::size_t i) { one(i); });
    for (const auto& file : files_)
      if (file) file->check_all_were_there();
    settle();
    if (!in_full_ && partial_) keeper_.remove(*partial_);
  }

 private:
  /// What could not be read or fitted, and the error that said so.
  struct Failure {
    std::string name, reason;
    std::exception_ptr error;
  };

  void open_all() {
    const MeasuredRequest request = request_of(flags_);
    for (const std::string& name : files_of(flags_.files)) {
      files_.emplace_back();
      if (auto failure = failure_of(name, [&] { files_.back() = std::make_unique<MeasuredFile>(name, request); })) {
        unopened_.push_back(std::move(*failure));
        continue;
      }
      for (std::size_t i = 0; i < files_.back()->size(); ++i) places_.push_back({files_.size() - 1, i});
    }
  }

  /// Bad input of one curve does not stop the others.
  static std::optional<Failure> failure_of(const std::string& name, const std::function<void()>& work) {
    try {
      work();
    } catch (const Error& error) {
      if (error.exit_code() != ExitCode::bad_input) throw;
      return Failure{name, error.what(), std::current_exception()};
    }
    return std::nullopt;
  }

  std::optional<MeasuredCurve> read(const Place& place) {
    const std::lock_guard lock(reading_);
    return files_[place.file]->read(place.curve);
  }

  void one(std::size_t i) {
    const Place place = places_[i];
    const std::string name = files_[place.file]->name(place.curve);
    std::optional<MeasuredCurve> curve;
    failures_[i] = failure_of(name, [&] {
      curve = read(place);
      if (curve) fit(i, *curve);
    });
    if (failures_[i]) {
      CurveRow row = curve ? row_of(*curve) : CurveRow{.file = name, .index = static_cast<int>(place.curve)};
      row.skipped = without_name(failures_[i]->reason, name);
      rows_[i] = row;
      keeper_.keep(row);
    }
    const std::size_t done = ++done_;
    if (places_.size() > most_in_full)
      progress_status(fmt::format("{} curves {} of {}",
                                  bar(static_cast<double>(done) / static_cast<double>(places_.size())), done,
                                  places_.size()));
  }

  void progress_status(const std::string& line) {
    const std::lock_guard lock(reporting_);
    progress_.status(line);
  }

  static std::string without_name(std::string message, const std::string& name) {
    const std::string start = name + ": ";
    return message.starts_with(start) ? message.substr(start.size()) : message;
  }

  void fit(std::size_t i, const MeasuredCurve& curve) {
    if (const CurveRow* known = in_full_ ? nullptr : keeper_.find(curve.source, curve.index)) {
      rows_[i] = *known;
      return;
    }
    MeasuredOptions options = options_of(flags_, curve, card_);
    options.quoted_alone = !in_full_;
    const std::string wrong = looks_wrong(curve, options.spring_constant_eV_per_A2);
    CurveRow row = row_of(curve);
    if (wrong.empty() || in_full_) {
      FittedCurve fitted = evaluate(curve, options);
      row = row_of(curve, fitted);
      fitted.notes.insert(fitted.notes.begin(), curve.notes.begin(), curve.notes.end());
      if (!wrong.empty()) fitted.notes.push_back("looks wrong, and is left out of means: " + wrong);
      if (in_full_) curves_[i] = std::move(fitted);
    }
    row.skipped = wrong;
    if (wrong.empty() && row.model.empty()) row.skipped = "no fit";
    rows_[i] = row;
    keeper_.keep(row);
  }

  void settle() {
    for (auto& curve : curves_)
      if (curve) result_.curves.push_back(std::move(*curve));
    std::vector<Failure> failures = std::move(unopened_);
    for (auto& failure : failures_)
      if (failure) failures.push_back(std::move(*failure));
    for (const Failure& failure : failures) result_.unfitted.push_back({failure.name, failure.reason});
    ManyCurves many;
    bool any = false;
    for (const auto& row : rows_)
      if (row) {
        any = any || std::isfinite(row->Eh_eV_per_A2);
        many.rows.push_back(*row);
      }
    if (!failures.empty() && !any) std::rethrow_exception(failures.front().error);
    if (in_full_)
      for (const UnfittedCurve& curve : result_.unfitted) spdlog::warn("not fitted: {}", curve.reason);
    if (many.rows.size() < 2) return;
    many.means = spread_means(many.rows);
    add_joint(many);
    many.wall_s = progress_.elapsed_s();
    result_.many = std::move(many);
  }

  /// The curves that are used, read again: their points are not kept meanwhile.
  void add_joint(ManyCurves& many) {
    if (card_ || !flags_.third_order.empty()) return;
    std::map<std::pair<std::string, int>, const CurveRow*> used;
    std::map<std::string, int> drums;
    double deepest = 0, share = 0;
    for (const CurveRow& row : many.rows) {
      if (!row.skipped.empty() || row.model != fitted_membrane) continue;
      used[{row.file, row.index}] = &row;
      drums.try_emplace(row.file, static_cast<int>(drums.size()));
      deepest = std::max(deepest, row.deepest_A);
      share = std::max(share, 1.3 * row.pretension_high_eV_per_A2 / row.Eh_eV_per_A2);
    }
    if (used.size() < 2) return;
    std::vector<std::optional<JointCurve>> slots(places_.size());
    double numerical = 0;
    on_all_cores(places_.size(), [&](std::size_t i) {
      std::optional<MeasuredCurve> curve;
      if (!rows_[i] || !rows_[i]->skipped.empty()) return;
      curve = read(places_[i]);
      if (!curve) return;
      const auto row = used.find({curve->source, curve->index});
      if (row == used.end()) return;
      const MeasuredOptions options = options_of(flags_, *curve, card_);
      double baseline = 0;
      const SheetModel sheet = sheet_model(options, std::nullopt, {1.05 * deepest, row->second->Eh_eV_per_A2, share});
      Likelihood likelihood(measured_points(*curve, options, baseline), sheet.model, options.free, sheet.inputs);
      Eigen::VectorXd start = start_of(likelihood, *row->second);
      const std::lock_guard lock(mutex_);
      numerical = std::max(numerical, sheet.model.relative_error);
      slots[i] = JointCurve{std::move(likelihood), std::move(start), drums.at(curve->source)};
    });
    std::vector<JointCurve> curves;
    for (auto& slot : slots)
      if (slot) curves.push_back(std::move(*slot));
    if (curves.size() < 2) return;
    JointOutcome outcome = joint_fit(std::move(curves), numerical, on_all_cores);
    if (!outcome.reason.empty()) {
      spdlog::warn("no joint fit: {}", outcome.reason);
      return;
    }
    double squares = 0;
    for (const auto& [key, row] : used)
      squares += std::pow((row->Eh_eV_per_A2 - outcome.fit.Eh_eV_per_A2) / row->Eh_noise_eV_per_A2, 2);
    outcome.fit.chi2_per_dof = squares / (static_cast<double>(used.size()) - 1);
    many.joint.push_back(std::move(outcome.fit));
  }

  static Eigen::VectorXd start_of(const Likelihood& likelihood, const CurveRow& row) {
    Eigen::VectorXd theta = likelihood.start();
    const double zero = std::isfinite(row.force_zero_nN) ? row.force_zero_nN / nN_per_eV_per_A : 0;
    theta[0] = row.Eh_eV_per_A2;
    theta[1] = row.pretension_eV_per_A2;
    if (const int i = likelihood.force_zero_index(); i >= 0) theta[i] = zero;
    if (const int i = likelihood.contact_index(); i >= 0)
      theta[i] = 10 * row.contact_nm + likelihood.points().compliance_A2_per_eV * zero;
    if (const int i = likelihood.slope_index(); i >= 0) theta[i] = row.slope_N_per_m / N_per_m_per_eV_per_A2;
    if (const int i = likelihood.force_noise_index(); i >= 0 && std::isfinite(row.sigma_force_nN))
      theta[i] = std::pow(row.sigma_force_nN / nN_per_eV_per_A, 2);
    if (const int i = likelihood.depth_noise_index(); i >= 0 && std::isfinite(row.sigma_depth_nm))
      theta[i] = std::pow(10 * row.sigma_depth_nm, 2);
    return theta;
  }

  const FitFlags& flags_;
  const std::optional<PotentialCard>& card_;
  const std::optional<fs::path>& partial_;
  RowKeeper keeper_;
  Result& result_;
  Progress progress_;
  std::vector<std::unique_ptr<MeasuredFile>> files_;
  std::vector<Place> places_;
  bool in_full_ = false;
  std::vector<std::optional<CurveRow>> rows_;
  std::vector<std::optional<FittedCurve>> curves_;
  std::mutex reading_, mutex_, reporting_;
  std::atomic<std::size_t> done_ = 0;
  std::vector<Failure> unopened_;
  std::vector<std::optional<Failure>> failures_;
};

}  // namespace

void on_all_cores(std::size_t n, const std::function<void(std::size_t)>& work) {
  const std::size_t threads = std::min(n, usable_cores().size());
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr failed;
  const auto take = [&] {
    try {
      for (std::size_t i = next++; i < n; i = next++) {
        if (interrupted()) throw Error(ExitCode::interrupted, "interrupted");
        work(i);
      }
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failed) failed = std::current_exception();
      next = n;
    }
  };
  std::vector<std::thread> others;
  for (std::size_t t = 1; t < threads; ++t) others.emplace_back(take);
  take();
  for (std::thread& thread : others) thread.join();
  if (failed) std::rethrow_exception(failed);
}

std::vector<std::string> files_of(const std::vector<std::string>& names) {
  std::vector<std::string> files;
  for (const std::string& name : names) {
    std::error_code ignored;
    if (!fs::is_directory(name, ignored)) {
      files.push_back(name);
      continue;
    }
    std::vector<std::string> inside;
    for (const auto& entry : fs::directory_iterator(name))
      if (entry.is_regular_file() && !entry.path().filename().string().starts_with(".")) inside.push_back(entry.path());
    if (inside.empty()) throw bad_input("{}: a folder without files", name);
    std::ranges::sort(inside);
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

void fit_curves(const FitFlags& flags, const std::optional<PotentialCard>& card, const std::optional<fs::path>& partial,
                Result& result) {
  ManyFits(flags, card, partial, result).run();
}

}  // namespace validate
