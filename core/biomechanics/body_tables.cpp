#include "core/biomechanics/body_tables.h"

#include <algorithm>
#include <utility>

namespace marey {
namespace {

using Proportions = std::array<PartProportions, kBodyPartCount>;

// In the order of BodyPart. The table has centres of head and trunk from their upper ends; here they are from the lower ones.
constexpr Proportions kMale = {{{242.9, 0.0694, 1.0 - 0.5002, 0.303, 0.315, 0.261},
                                {515.5, 0.4346, 1.0 - 0.4310, 0.384, 0.358, 0.197},
                                {281.7, 0.0271, 0.5772, 0.285, 0.269, 0.158},
                                {268.9, 0.0162, 0.4574, 0.276, 0.265, 0.121},
                                {187.9, 0.0061, 0.3624, 0.288, 0.235, 0.184},
                                {422.2, 0.1416, 0.4095, 0.329, 0.329, 0.149},
                                {440.3, 0.0433, 0.4395, 0.251, 0.246, 0.102},
                                {258.1, 0.0137, 0.5, 0.475, 0.475, 0.124}}};
constexpr Proportions kFemale = {{{243.7, 0.0668, 1.0 - 0.4841, 0.271, 0.295, 0.261},
                                  {497.9, 0.4257, 1.0 - 0.3782, 0.379, 0.361, 0.182},
                                  {275.1, 0.0255, 0.5754, 0.278, 0.260, 0.148},
                                  {264.3, 0.0138, 0.4559, 0.261, 0.257, 0.094},
                                  {170.1, 0.0056, 0.3427, 0.244, 0.208, 0.154},
                                  {368.5, 0.1478, 0.3612, 0.369, 0.364, 0.162},
                                  {438.6, 0.0481, 0.4352, 0.267, 0.263, 0.092},
                                  {228.3, 0.0129, 0.5, 0.475, 0.475, 0.139}}};

// The hand ends at the knuckle there, 86.2 mm from the wrist, here at the fingertip.
constexpr double kKnuckle = 86.2 / 187.9;
constexpr Proportions kWinter = {{{242.9, 0.081, kMale[0].com, 0.303, 0.315, 0.261},
                                  {515.5, 0.497, 0.50, 0.384, 0.358, 0.197},
                                  {281.7, 0.028, 0.436, 0.322, 0.322, 0.158},
                                  {268.9, 0.016, 0.430, 0.303, 0.303, 0.121},
                                  {187.9, 0.006, 0.506 * kKnuckle, 0.297 * kKnuckle, 0.297 * kKnuckle, 0.184 * kKnuckle},
                                  {422.2, 0.100, 0.433, 0.323, 0.323, 0.149},
                                  {440.3, 0.0465, 0.433, 0.302, 0.302, 0.102},
                                  {258.1, 0.0145, 0.5, 0.475, 0.475, 0.124}}};

/// A piece of the trunk in mm: lower end above mid hips, length, mass, centre from its upper end and radii of its length.
constexpr TrunkPiece piece(double trunk_mm, double begin_mm, double length_mm, double mass, double com, double sagittal,
                           double transverse, double longitudinal) {
  const double scale = length_mm / trunk_mm;
  return {std::min((begin_mm + length_mm) / trunk_mm, 1.0),
          mass,
          (begin_mm + (1.0 - com) * length_mm) / trunk_mm,
          sagittal * scale,
          transverse * scale,
          longitudinal * scale};
}

// Lower, middle and upper trunk; the upper one from the xiphion to the seventh vertebra (Upper trunk 2).
constexpr std::array<TrunkPiece, 3> kMaleTrunk = {piece(515.5, 0.0, 145.7, 0.1117, 0.6115, 0.615, 0.551, 0.587),
                                                  piece(515.5, 145.7, 215.5, 0.1633, 0.4502, 0.482, 0.383, 0.468),
                                                  piece(515.5, 361.2, 242.1, 0.1596, 0.5066, 0.505, 0.320, 0.465)};
constexpr std::array<TrunkPiece, 3> kFemaleTrunk = {piece(497.9, 0.0, 181.5, 0.1247, 0.4920, 0.433, 0.402, 0.444),
                                                    piece(497.9, 181.5, 205.3, 0.1465, 0.4512, 0.433, 0.354, 0.415),
                                                    piece(497.9, 386.8, 228.0, 0.1545, 0.5050, 0.466, 0.314, 0.449)};

constexpr std::array<TrunkPiece, 3> kWinterTrunk = {piece(515.5, 0.0, 145.7, 0.142, 0.6115, 0.615, 0.551, 0.587),
                                                    piece(515.5, 145.7, 215.5, 0.139, 0.4502, 0.482, 0.383, 0.468),
                                                    piece(515.5, 361.2, 242.1, 0.216, 0.5066, 0.505, 0.320, 0.465)};

// In the order of BodyTable.
constexpr std::array<std::pair<std::string_view, BodyTable>, 4> kTables = {{{"deleva-male", BodyTable::DeLevaMale},
                                                                             {"deleva-female", BodyTable::DeLevaFemale},
                                                                             {"winter", BodyTable::Winter},
                                                                             {"rods", BodyTable::Rods}}};

}  // namespace

std::string_view body_part_name(BodyPart part) {
  static constexpr std::array<std::string_view, kBodyPartCount> kNames = {"head",    "trunk", "upper arm", "forearm",
                                                                          "hand",    "thigh", "shank",     "foot"};
  return kNames[static_cast<std::size_t>(part)];
}

const BodyTable* find_body_table(std::string_view name) {
  const auto found = std::find_if(kTables.begin(), kTables.end(), [&](const auto& table) { return table.first == name; });
  return found == kTables.end() ? nullptr : &found->second;
}

std::string_view body_table_name(BodyTable table) { return kTables[static_cast<std::size_t>(table)].first; }

const PartProportions& proportions_of(BodyTable table, BodyPart part) {
  const Proportions& all = table == BodyTable::DeLevaFemale ? kFemale : table == BodyTable::Winter ? kWinter : kMale;
  return all[static_cast<std::size_t>(part)];
}

const std::array<TrunkPiece, 3>& trunk_pieces_of(BodyTable table) {
  return table == BodyTable::DeLevaFemale ? kFemaleTrunk : table == BodyTable::Winter ? kWinterTrunk : kMaleTrunk;
}

double neck_height_mm(BodyTable table) { return table == BodyTable::DeLevaFemale ? 614.8 - 497.9 : 603.3 - 515.5; }

}  // namespace marey
