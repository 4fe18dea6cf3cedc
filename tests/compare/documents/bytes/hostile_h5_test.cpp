// Result files that somebody else has made, or spoilt: each is refused with an error that names the file's fault.
#include <gtest/gtest.h>
#include <hdf5.h>

#include <functional>
#include <limits>

#include "compare/base/errors.hpp"
#include "compare/documents/bytes/run_h5.hpp"
#include "compare/documents/bytes/run_h5_read.hpp"
#include "tests/compare/results/complete_result.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace validate;

namespace {

using Spoil = std::function<void(hid_t file)>;

/// A good file of a bulge with one thing spoilt.
void spoil(const std::filesystem::path& path, const Spoil& change) {
  write_run_h5(sample::complete(Command::bulge), path);
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  ASSERT_GE(file, 0);
  change(file);
  ASSERT_GE(H5Fclose(file), 0);
}

void replace_attribute(hid_t file, const char* group, const char* name, hid_t type, hid_t space, const void* value) {
  ASSERT_GE(H5Adelete_by_name(file, group, name, H5P_DEFAULT), 0);
  const hid_t attribute = H5Acreate_by_name(file, group, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  ASSERT_GE(attribute, 0);
  if (value) {
    ASSERT_GE(H5Awrite(attribute, type, value), 0);
  }
  H5Aclose(attribute);
}

void replace_set(hid_t file, const char* name, hid_t type, const std::vector<hsize_t>& size, hid_t properties,
                 const void* values) {
  ASSERT_GE(H5Ldelete(file, name, H5P_DEFAULT), 0);
  const hid_t space = H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr);
  const hid_t set = H5Dcreate2(file, name, type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
  ASSERT_GE(set, 0);
  if (values) {
    ASSERT_GE(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), 0);
  }
  H5Dclose(set);
  H5Sclose(space);
}

constexpr const char* depths = "/runs/0/depth_A";
constexpr double three_numbers[] = {1, 2, 3};

hid_t fixed_text(std::size_t size) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, size);
  return type;
}

hid_t scalar() { return H5Screate(H5S_SCALAR); }

hid_t chunked(hsize_t size) {
  const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(properties, 1, &size);
  return properties;
}

struct Number {
  double value;
  int other;
};

hid_t compound() {
  const hid_t type = H5Tcreate(H5T_COMPOUND, sizeof(Number));
  H5Tinsert(type, "value", HOFFSET(Number, value), H5T_NATIVE_DOUBLE);
  H5Tinsert(type, "other", HOFFSET(Number, other), H5T_NATIVE_INT);
  return type;
}

struct Fault {
  const char* name;
  Spoil spoil;
  const char* word;  ///< of the message
};

const Fault faults[] = {
    {"AttributeOfFixedLength",
     [](hid_t f) { replace_attribute(f, "/provenance", "git", fixed_text(8), scalar(), "abcdefgh"); }, "git"},
    {"ModelOfFixedLength", [](hid_t f) { replace_attribute(f, "/runs/0", "model", fixed_text(1), scalar(), "m"); },
     "model"},
    {"CommandOfFixedLength", [](hid_t f) { replace_attribute(f, "/", "command", fixed_text(5), scalar(), "bulge"); },
     "command"},
    {"CommandThatIsNone",
     [](hid_t f) {
       const hid_t type = H5Tcopy(H5T_C_S1);
       H5Tset_size(type, H5T_VARIABLE);
       const char* word = "destroy";
       replace_attribute(f, "/", "command", type, scalar(), &word);
     },
     "destroy"},
    {"TextsOfFixedLength",
     [](hid_t f) {
       const hsize_t three = 3;
       replace_attribute(f, "/runs/0/fits/0", "warnings", fixed_text(2), H5Screate_simple(1, &three, nullptr),
                         "aabbcc");
     },
     "warnings"},
    {"NumberForText",
     [](hid_t f) { replace_attribute(f, "/provenance", "git", H5T_NATIVE_DOUBLE, scalar(), three_numbers); }, "git"},
    {"TextForNumber", [](hid_t f) { replace_attribute(f, "/runs/0", "a_A", fixed_text(3), scalar(), "abc"); }, "a_A"},
    {"SeveralForOne",
     [](hid_t f) {
       const hsize_t three = 3;
       replace_attribute(f, "/runs/0", "a_A", H5T_NATIVE_DOUBLE, H5Screate_simple(1, &three, nullptr), three_numbers);
     },
     "a_A"},
    {"NoneForOne",
     [](hid_t f) { replace_attribute(f, "/runs/0", "a_A", H5T_NATIVE_DOUBLE, H5Screate(H5S_NULL), nullptr); }, "a_A"},
    {"OneForAPair",
     [](hid_t f) { replace_attribute(f, "/agreement", "window", H5T_NATIVE_DOUBLE, scalar(), three_numbers); },
     "window"},
    {"SchemaOfAnother",
     [](hid_t f) { replace_attribute(f, "/", "schema", H5T_NATIVE_DOUBLE, scalar(), &three_numbers[2]); }, "schema"},
    {"WholeNumberThatIsNone",
     [](hid_t f) {
       const double nan = std::numeric_limits<double>::quiet_NaN();
       replace_attribute(f, "/runs/0", "triangles", H5T_NATIVE_DOUBLE, scalar(), &nan);
     },
     "triangles"},
    {"WholeNumberBeyondAll",
     [](hid_t f) {
       const double large = 1e300;
       replace_attribute(f, "/sheet", "atoms", H5T_NATIVE_DOUBLE, scalar(), &large);
     },
     "atoms"},
    {"CompoundAttribute",
     [](hid_t f) {
       const Number number{1, 2};
       replace_attribute(f, "/runs/0", "a_A", compound(), scalar(), &number);
     },
     "a_A"},
    {"CompoundColumn",
     [](hid_t f) {
       const Number numbers[3] = {};
       replace_set(f, depths, compound(), {3}, H5P_DEFAULT, numbers);
     },
     "depth_A"},
    {"TextColumn", [](hid_t f) { replace_set(f, depths, fixed_text(1), {3}, H5P_DEFAULT, "abc"); }, "depth_A"},
    {"ShortColumn", [](hid_t f) { replace_set(f, depths, H5T_NATIVE_DOUBLE, {2}, H5P_DEFAULT, three_numbers); },
     "columns of"},
    {"MissingColumn", [](hid_t f) { H5Ldelete(f, "/unloading/0/force_eV_per_A", H5P_DEFAULT); }, "missing"},
    {"MissingColumnOfAtoms", [](hid_t f) { H5Ldelete(f, "/runs/1/artefact", H5P_DEFAULT); }, "artefact"},
    {"MissingColumnOfARun", [](hid_t f) { H5Ldelete(f, "/runs/1/force_eV_per_A", H5P_DEFAULT); }, "force_eV_per_A"},
    {"AClaimOfMegabytes",
     [](hid_t f) { replace_set(f, depths, H5T_NATIVE_DOUBLE, {hsize_t{1} << 25}, chunked(1024), nullptr); }, "depth_A"},
    {"TwoDimensions",
     [](hid_t f) {
       replace_set(f, depths, H5T_NATIVE_DOUBLE, {3, 1}, H5P_DEFAULT, three_numbers);
     },
     "depth_A"},
    {"AClaimOfTerabytes",
     [](hid_t f) { replace_set(f, depths, H5T_NATIVE_DOUBLE, {hsize_t{1} << 40}, chunked(1024), nullptr); }, "depth_A"},
    {"TextsByTheBillion",
     [](hid_t f) {
       const hid_t type = H5Tcopy(H5T_C_S1);
       H5Tset_size(type, H5T_VARIABLE);
       replace_set(f, "/comparison/0/regime", type, {hsize_t{1} << 40}, chunked(1024), nullptr);
     },
     "regime"},
    {"AnUnknownWordInAColumn",
     [](hid_t f) {
       const hid_t type = H5Tcopy(H5T_C_S1);
       H5Tset_size(type, H5T_VARIABLE);
       const char* words[] = {"bending", "flying", nullptr};
       replace_set(f, "/comparison/0/regime", type, {3}, H5P_DEFAULT, words);
     },
     "flying"},
    {"SoftLinkToNowhere",
     [](hid_t f) {
       H5Ldelete(f, depths, H5P_DEFAULT);
       ASSERT_GE(H5Lcreate_soft("/nowhere", f, depths, H5P_DEFAULT, H5P_DEFAULT), 0);
     },
     "depth_A"},
    {"SoftLinkOfAGroup",
     [](hid_t f) {
       H5Ldelete(f, "/card", H5P_DEFAULT);
       ASSERT_GE(H5Lcreate_soft("/", f, "/card", H5P_DEFAULT, H5P_DEFAULT), 0);
     },
     "card"},
    {"ExternalLink",
     [](hid_t f) {
       H5Ldelete(f, depths, H5P_DEFAULT);
       ASSERT_GE(H5Lcreate_external("/etc/other.h5", "/x", f, depths, H5P_DEFAULT, H5P_DEFAULT), 0);
     },
     "depth_A"},
    {"ExternalLinkOfAGroup",
     [](hid_t f) {
       H5Ldelete(f, "/provenance", H5P_DEFAULT);
       ASSERT_GE(H5Lcreate_external("/etc/other.h5", "/x", f, "/provenance", H5P_DEFAULT, H5P_DEFAULT), 0);
     },
     "provenance"},
    {"ValuesInAnotherFile",
     [](hid_t f) {
       const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
       H5Pset_external(properties, "/etc/passwd", 0, 24);
       replace_set(f, depths, H5T_NATIVE_DOUBLE, {3}, properties, nullptr);
     },
     "another file"},
    {"AGroupForAColumn",
     [](hid_t f) {
       H5Ldelete(f, depths, H5P_DEFAULT);
       H5Gclose(H5Gcreate2(f, depths, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
     },
     "depth_A"},
    {"AColumnForAGroup", [](hid_t f) { replace_set(f, "/card", H5T_NATIVE_DOUBLE, {3}, H5P_DEFAULT, three_numbers); },
     "card"},
    {"ATriangleOfNoNode",
     [](hid_t f) {
       const int corners[] = {0, 1, 2, 0, 1, 4};
       replace_set(f, "/runs/0/fields/0/triangles", H5T_NATIVE_INT, {6}, H5P_DEFAULT, corners);
     },
     "node"},
    {"ATriangleOfTwo",
     [](hid_t f) {
       const int corners[] = {0, 1};
       replace_set(f, "/runs/0/fields/0/triangles", H5T_NATIVE_INT, {2}, H5P_DEFAULT, corners);
     },
     "threes"},
    {"AFieldOfAnotherLength",
     [](hid_t f) {
       replace_set(f, "/runs/0/fields/0/at_triangles/state", H5T_NATIVE_DOUBLE, {3}, H5P_DEFAULT, three_numbers);
     },
     "state"},
};

class HostileH5 : public testing::TestWithParam<Fault> {};

TEST_P(HostileH5, IsRefused) {
  const TemporaryFolder folder;
  spoil(folder / "run.h5", GetParam().spoil);
  try {
    read_run_h5(folder / "run.h5");
    FAIL() << "accepted";
  } catch (const Error& error) {
    const ExitCode code = error.exit_code();
    EXPECT_TRUE(code == ExitCode::bad_input || code == ExitCode::file_failed) << static_cast<int>(code);
    EXPECT_NE(std::string(error.what()).find(GetParam().word), std::string::npos) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(Faults, HostileH5, testing::ValuesIn(faults),
                         [](const auto& test) { return std::string(test.param.name); });

/// Of an enumeration of 64 bit only the values count.
TEST(HostileH5More, WideEnumerationsAreReadAsTheyAre) {
  const TemporaryFolder folder;
  spoil(folder / "run.h5", [](hid_t f) {
    const hid_t type = H5Tenum_create(H5T_NATIVE_INT64);
    const std::int64_t no = 0, yes = 1, values[] = {1, 0, 1};
    H5Tenum_insert(type, "FALSE", &no);
    H5Tenum_insert(type, "TRUE", &yes);
    replace_set(f, "/runs/0/converged", type, {3}, H5P_DEFAULT, values);
  });
  EXPECT_EQ(read_run_h5(folder / "run.h5").runs.at(0).converged, (std::vector<bool>{true, false, true}));
}

/// What may lack may be missing: /runs/1 are the atoms.
TEST(HostileH5More, AColumnThatMayLackCan) {
  const TemporaryFolder folder;
  spoil(folder / "run.h5", [](hid_t f) { H5Ldelete(f, "/runs/1/longest_bond_A", H5P_DEFAULT); });
  const Result read = read_run_h5(folder / "run.h5");
  EXPECT_TRUE(read.runs.at(1).longest_bond_A.empty());
  EXPECT_EQ(read.runs.at(1).depth_A.size(), 3u);
}

TEST(HostileH5More, ABatchThatHoldsItselfIsRefused) {
  const TemporaryFolder folder;
  write_run_h5(sample::complete(Command::batch), folder / "run.h5");
  const hid_t file = H5Fopen((folder / "run.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  ASSERT_GE(H5Ldelete(file, "/cases/0/summary", H5P_DEFAULT), 0);
  ASSERT_GE(H5Lcreate_hard(file, "/", file, "/cases/0/summary", H5P_DEFAULT, H5P_DEFAULT), 0);
  H5Fclose(file);
  EXPECT_THROW(read_run_h5(folder / "run.h5"), Error);
}

/// A small file that would be a large result.
TEST(HostileH5More, ManyLinksToOneGroupAreRefused) {
  const TemporaryFolder folder;
  spoil(folder / "run.h5", [](hid_t f) {
    for (int i = 3; i < 3000; ++i)
      ASSERT_GE(H5Lcreate_hard(f, "/runs/0", f, ("/runs/" + std::to_string(i)).c_str(), H5P_DEFAULT, H5P_DEFAULT), 0);
  });
  EXPECT_THROW(read_run_h5(folder / "run.h5"), Error);
}

}  // namespace
