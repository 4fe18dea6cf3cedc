// The fields of solved sheets in HDF5: the same columns as in the VTU files.
#pragma once

#include "compare/documents/bytes/h5.hpp"
#include "compare/documents/bytes/h5_read.hpp"
#include "compare/results/sheet_columns.hpp"

namespace validate {

/// A group with nodes (Å, three a node, flat sheet), triangles (three node numbers each) and every column;
/// units, meanings and the number of components are attributes of them, the totals of the full sheet
/// attributes of the group.
void write_fields(h5::Group& parent, const std::string& name, const SheetPicture& picture);

/// The picture that such a group holds: all that is drawn of it. Throws Error (file failed) where lengths or node
/// numbers do not fit each other.
SheetPicture read_fields(const h5::ReadGroup& group);

}  // namespace validate
