// Reads run.h5 back with the plain C library, as any other program would.
#include "compare/documents/bytes/run_h5.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>

#include "compare/base/errors.hpp"
#include "tests/compare/results/sample_result.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace validate;

namespace {

class RunH5 : public testing::Test {
 protected:
  void write(const Result& result) {
    write_run_h5(result, folder_ / "run.h5");
    file_ = H5Fopen((folder_ / "run.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    ASSERT_GE(file_, 0);
  }
  void TearDown() override {
    if (file_ >= 0) H5Fclose(file_);
  }

  bool exists(const std::string& path) const { return H5Lexists(file_, path.c_str(), H5P_DEFAULT) > 0; }

  double number(const std::string& object, const std::string& attribute) const {
    double value = -1;
    const hid_t id = H5Aopen_by_name(file_, object.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    EXPECT_GE(id, 0) << object << ' ' << attribute;
    if (id < 0) return value;
    EXPECT_GE(H5Aread(id, H5T_NATIVE_DOUBLE, &value), 0);
    H5Aclose(id);
    return value;
  }

  std::string text(const std::string& object, const std::string& attribute) const {
    const hid_t id = H5Aopen_by_name(file_, object.c_str(), attribute.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    EXPECT_GE(id, 0) << object << ' ' << attribute;
    if (id < 0) return "";
    const hid_t type = H5Aget_type(id);
    char* read = nullptr;
    EXPECT_GE(H5Aread(id, type, &read), 0);
    const std::string value = read ? read : "";
    H5free_memory(read);
    H5Tclose(type);
    H5Aclose(id);
    return value;
  }

  std::vector<double> column(const std::string& path) const {
    const hid_t set = H5Dopen2(file_, path.c_str(), H5P_DEFAULT);
    EXPECT_GE(set, 0) << path;
    if (set < 0) return {};
    const hid_t space = H5Dget_space(set);
    std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    if (!values.empty()) {
      EXPECT_GE(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
    }
    H5Sclose(space);
    H5Dclose(set);
    return values;
  }

  TemporaryFolder folder_;
  hid_t file_ = -1;
};

TEST_F(RunH5, HoldsTheCurvesWithUnitAndMeaning) {
  const Result result = sample::full();
  write(result);
  EXPECT_EQ(folder_.entries(), 1u);
  EXPECT_EQ(number("/", "schema"), 2);
  EXPECT_EQ(text("/", "command"), "indentation");
  for (std::size_t i = 0; i < result.runs.size(); ++i) {
    const std::string run = "/runs/" + std::to_string(i);
    EXPECT_EQ(column(run + "/depth_A"), result.runs[i].depth_A);
    EXPECT_EQ(column(run + "/force_eV_per_A"), result.runs[i].force_eV_per_A);
    EXPECT_EQ(text(run + "/force_eV_per_A", "unit"), "eV/Å");
    EXPECT_EQ(text(run + "/force_eV_per_A", "meaning"), "total force on the full sheet");
    EXPECT_EQ(text(run, "model"), to_string(result.runs[i].model));
    EXPECT_EQ(number(run + "/fits/0", "Eh_eV_per_A2"), result.runs[i].fits.at(0).Eh_eV_per_A2);
  }
  EXPECT_EQ(number("/runs/5", "Eh_eV_per_A2"), result.runs[5].Eh_eV_per_A2);
  EXPECT_NEAR(number("/card", "Eh_N_per_m"), 277.657, 1e-3);  // 17.33 × 16.02176634
  EXPECT_EQ(number("/case", "radius_A"), 110);
  EXPECT_EQ(number("/case/agreement", "tolerance"), 0.01);
  EXPECT_EQ(text("/provenance", "lammps"), result.provenance.lammps);
  EXPECT_EQ(text("/agreement", "outcome"), to_string(result.agreement->outcome));
  for (std::size_t i = 0; i < result.agreement->ratios.size(); ++i)
    EXPECT_EQ(number("/agreement/ratios/" + std::to_string(i), "ratio"), result.agreement->ratios[i].ratio);
}

TEST_F(RunH5, StoresFlagsAsTheBooleansOfH5py) {
  const Result result = sample::full();
  write(result);
  const hid_t set = H5Dopen2(file_, "/runs/0/artefact", H5P_DEFAULT), type = H5Dget_type(set);
  EXPECT_EQ(H5Tget_class(type), H5T_ENUM);
  EXPECT_EQ(H5Tget_nmembers(type), 2);
  std::vector<signed char> values(result.runs[0].atoms().artefact.size());
  ASSERT_GE(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(values[i], result.runs[0].atoms().artefact[i]) << i;
  H5Tclose(type);
  H5Dclose(set);
}

TEST_F(RunH5, LeavesOutWhatFailed) {
  write(sample::atoms_failed());
  EXPECT_FALSE(exists("/card"));
  EXPECT_FALSE(exists("/agreement"));
  EXPECT_FALSE(exists("/runs/0/fits/0"));
  EXPECT_TRUE(column("/runs/0/depth_A").empty());
  EXPECT_EQ(H5Aexists_by_name(file_, "/runs/0", "ended", H5P_DEFAULT), 0);
  EXPECT_NE(text("/runs/0", "fit_skipped"), "");
  EXPECT_NE(text("/", "agreement_skipped"), "");
}

TEST_F(RunH5, SaysWhichFileCannotBeWritten) {
  try {
    write_run_h5(sample::full(), folder_ / "missing/run.h5");
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_code(), ExitCode::file_failed);
    EXPECT_NE(std::string(error.what()).find("run.h5"), std::string::npos);
  }
}

}  // namespace
