// Exports files of tables: the IC file itself, and the text from which the CONTACT program (E.A.H. Vollebregt, user
// guide, digit C3 = 9) reads numerical influence coefficients.
#pragma once

#include <string>
#include <vector>

#include "contactd/given_ics.hpp"
#include "contactd/ic_store.hpp"
#include "contactd/material.hpp"

namespace contactd {

/// Returns the bytes of an IC file, as write_ic_file writes them. If the spec of `record` has dimensions, the file
/// contains mm^3/N, with dx, dy and G.
std::vector<unsigned char> to_ic_file(const IcRecord& record);

/// Returns CONTACT's combined modulus of rigidity, the factor of its coefficients: 1/G = (1/G_upper + 1/G_lower)/2.
double combined_modulus(const MaterialPair& bodies);

/// The pair's table as text; `G` is that of combined_modulus. Lines:
///     nmatrix iaconvex     1 1: one table for every row of elements; CONTACT's body 1 is the upper one
///     0 312                nine columns, in the order z (normal), x, y
///     1 0                  offsets -ix follow from ix by symmetry, offsets -iy are listed
///     mx my dx dy          extent and element sizes
/// and for each y offset -my+1..my-1 two comment lines and mx lines `ix x Czz Czx Czy Cxz Cxx Cxy Cyz Cyx Cyy`, Cij = G
/// times displacement i for load j, in 17 significant digits (read back and divided by G it is the coefficient to
/// rounding). Signs are as in pair_of, which are CONTACT's. The Python client reads it (contactd.load_table).
std::string to_contact_text(const GivenIcs& ics, double G);

/// Returns the approximate length of to_contact_text (bytes), before memory is allocated.
double contact_text_size(int nx, int ny);

/// Returns the SHA-256 (hex) of a given table, its extent and its element sizes.
std::string ic_key(const GivenIcs& ics);

}  // namespace contactd
