#include "core/biomechanics/analysis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <sstream>

#include "core/math/angle.h"
#include "tests/core/biomechanics/body_fixtures.h"
#include "tests/support/files.h"

namespace marey::test {
namespace {

AnalysisRequest gymnast_request(double frame_time_s) {
  AnalysisRequest request;
  request.quantities = {"torque:*", "reaction", "com", "kinetic_energy", "potential_energy", "angular_momentum:Arms"};
  request.model = make_gymnast_model();
  request.support = SupportKind::Pivot;
  request.frame_time_s = frame_time_s;
  return request;
}

/// The columns of the shared table of expected results, in its order, without weights and total energy.
const std::vector<std::string> kOracleColumns = {
    "torque:Arms.z[N.m]", "torque:Body.z[N.m]", "torque:Legs.z[N.m]", "reaction.x[N]", "reaction.y[N]", "com.x[m]", "com.y[m]",
    "kinetic_energy[J]", "potential_energy[J]", "angular_momentum:Arms.z[kg.m2/s]"};

struct OracleRow {
  double frame_time_s;
  FrameIndex frame;
  std::vector<double> values;
};

// Shared theory, section 7.3; found alike by PyKDL 1.5.1, MuJoCo 2.2.2 and, for frame 12, DART 6.12 and Simbody 3.7.
const std::vector<OracleRow> kOracle = {
    {0.066667, 6, {-199.50761, -61.90124, -47.15727, 1234.82350, 151.59105, -.98465, .10337, 705.78184, 70.98355, 343.47738}},
    {0.066667, 11, {55.71952, 99.31500, -103.64712, -443.23980, 3270.66383, .12139, -.97950, 1653.64243, -672.62364, 525.19015}},
    {0.066667, 12, {37.47891, 171.01373, -33.49078, -1565.32879, 2734.16069, .49308, -.85646, 1591.61940, -588.13169, 515.21212}},
    {0.066667, 18, {-428.92092, -224.54924, -55.02072, 31.36232, -454.49227, .60468, .76766, 410.56152, 527.14873, 257.73950}},
    {0.033333, 11, {-27.19855, 265.77316, -379.78640, -1773.01239, 11022.8654, .12139, -.97950, 6614.76815, -672.62364, 1050.39605}},
    {0.033333, 12, {-865.91006, 133.47775, -226.13560, -6261.50299, 8876.78847, .49308, -.85646, 6366.66860, -588.13169, 1030.43969}}};

TEST(InverseDynamics, OfTheGiantSwingIsThatOfOtherEngines) {
  for (const OracleRow& row : kOracle) {
    const AnalysisTable table = table_of(make_gymnast(), gymnast_request(row.frame_time_s));
    for (std::size_t i = 0; i < kOracleColumns.size(); ++i) {
      const double found = column_of(table, kOracleColumns[i])[idx(row.frame - 1)];
      EXPECT_NEAR(found, row.values[i], 1e-6 * std::abs(row.values[i]) + 5.1e-6) << kOracleColumns[i] << ", frame " << row.frame;
    }
  }
}

TEST(InverseDynamics, OfTheGiantSwingIsThatOfTheSharedTables) {
  int rows = 0;
  for (const auto& [name, frame_time_s] : {std::pair("as_printed_dt0.033333", 0.033333), std::pair("retimed_dt0.066667", 0.066667)}) {
    const auto text = read_shared_file(std::string("oracle/gymnast_invdyn_fixtureD_") + name + ".csv");
    if (!text) GTEST_SKIP() << "the shared tables are not here";
    const AnalysisTable table = table_of(make_gymnast(), gymnast_request(frame_time_s));
    std::istringstream lines(*text);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
      std::vector<double> cells;
      std::istringstream row(line);
      for (std::string cell; std::getline(row, cell, ',');) cells.push_back(std::stod(cell));
      ASSERT_EQ(cells.size(), 13u);
      const auto frame = static_cast<FrameIndex>(cells[0]) - 1;
      cells.erase(cells.begin() + 11);
      cells.erase(cells.begin() + 6);
      for (std::size_t i = 0; i < kOracleColumns.size(); ++i) {
        const double found = column_of(table, kOracleColumns[i])[idx(frame)];
        EXPECT_NEAR(found, cells[i + 1], 1e-6 * std::abs(cells[i + 1]) + 1e-6) << kOracleColumns[i] << ", frame " << cells[0];
      }
      ++rows;
    }
  }
  EXPECT_EQ(rows, 42);
  std::cout << rows << " rows of the shared tables compared\n";
}

// Shared theory, section 7.2: largest angular velocities and accelerations.
TEST(Analysis, KinematicsOfTheGiantSwing) {
  AnalysisRequest request;
  request.quantities = {"angular_velocity:*", "angular_acceleration:Arms", "angle:Legs", "position:*", "velocity:Legs_end"};
  const AnalysisTable table = table_of(make_gymnast(), request);
  EXPECT_NEAR(column_of(table, "angular_velocity:Arms.z[rad/s]")[9], to_radians(651.0065), 1e-6);
  EXPECT_NEAR(column_of(table, "angular_velocity:Body.z[rad/s]")[12], to_radians(765.0077), 1e-6);
  EXPECT_NEAR(column_of(table, "angular_velocity:Legs.z[rad/s]")[11], to_radians(1072.5107), 1e-6);
  EXPECT_NEAR(column_of(table, "angular_acceleration:Arms.z[rad/s2]")[17], to_radians(-3420.07), 2e-4);
  EXPECT_NEAR(column_of(table, "angle:Legs.z[rad]")[11], to_radians(-11.1), 1e-12);
  EXPECT_NEAR(column_of(table, "position:Legs_end.x[m]")[22], -4.706849 * 0.055, 1e-6);
  EXPECT_NEAR(column_of(table, "position:Body.y[m]")[0], 9.583226 * 0.055, 1e-6);
  const double speed = std::hypot(column_of(table, "velocity:Legs_end.x[m/s]")[11], column_of(table, "velocity:Legs_end.y[m/s]")[11]);
  EXPECT_NEAR(speed / 0.055, 522.3756, 1e-3);
}

TEST(Analysis, LeavesEndsOpenWhereDifferencesAreOneSided) {
  AnalysisRequest request;
  request.quantities = {"position:Arms", "velocity:Body"};
  const AnalysisTable table = table_of(make_gymnast(), request);
  const auto& velocity = column_of(table, "velocity:Body.x[m/s]");
  EXPECT_TRUE(std::isnan(velocity.front()));
  EXPECT_TRUE(std::isnan(velocity.back()));
  EXPECT_FALSE(std::isnan(velocity[1]));
  EXPECT_EQ(column_of(table, "position:Arms.x[m]").front(), 0.0);
  request.derivation = *parse_derivation("savgol:7,3");
  const AnalysisTable fitted = table_of(make_gymnast(), request);
  EXPECT_FALSE(std::isnan(column_of(fitted, "velocity:Body.x[m/s]").front()));
}

TEST(Analysis, SaysWhatItCannotDo) {
  const auto message_of = [](const AnalysisRequest& request) {
    const auto table = analyse(make_gymnast(), request);
    return table ? std::string() : table.error().message;
  };
  AnalysisRequest request;
  request.quantities = {"torque:Arms"};
  EXPECT_EQ(message_of(request), "'torque' needs the masses of the segments; give a model of the body, or a table to make one by.");
  request.model.emplace();
  EXPECT_EQ(message_of(request), "The body has no mass.");
  request.model = make_gymnast_model();
  request.model->segments[1].inertia_kgm2[2][2] = -1.0;
  EXPECT_EQ(message_of(request), "The segment of Body has an inertia that no body has: a principal moment is below 0.");
  request.quantities = {"torque"};
  EXPECT_EQ(message_of(request), "'torque' is of a joint: write torque:JOINT, or torque:* for all.");
  request.quantities = {"torque:Head"};
  EXPECT_EQ(message_of(request), "There is no joint 'Head'.");
  request.quantities = {"com:Arms"};
  EXPECT_EQ(message_of(request), "'com' is of the whole body; no joint stands behind it.");
  request.quantities = {"speed:Arms"};
  EXPECT_THAT(message_of(request), testing::StartsWith("'speed' is not a quantity; there are position, velocity,"));
  request.quantities = {"velocity:Arms"};
  request.derivation = {.kind = DerivationKind::Butterworth, .cutoff_hz = 15.1};
  EXPECT_THAT(message_of(request), testing::StartsWith("The cut-off is below half the frame rate"));
  request.derivation = {.kind = DerivationKind::SavitzkyGolay, .window = 25, .degree = 3};
  EXPECT_EQ(message_of(request), "'savgol:25,3' needs 25 frames; the clip has 23.");
}

TEST(Analysis, TakesClipsOfAnyLength) {
  for (const int frames : {0, 1, 2, 3, 4, 7}) {
    Clip clip = make_gymnast();
    clip.motion = clip.motion.frames_of({0, frames});
    for (const char* method : {"central", "butterworth:6", "savgol:3,2", "gcv", "spline:0.5,1"}) {
      AnalysisRequest request = gymnast_request(0.033333);
      request.derivation = *parse_derivation(method);
      for (const SupportKind support : {SupportKind::Pivot, SupportKind::Flight, SupportKind::Ground, SupportKind::Auto}) {
        request.support = support;
        const auto table = analyse(clip, request);
        if (!table) continue;
        for (const AnalysisColumn& column : table->columns) EXPECT_EQ(size_of(column.values), frames) << method;
      }
    }
  }
}

TEST(Derivation, IsReadAsItIsWritten) {
  for (const char* text : {"central", "butterworth:6", "butterworth:4.5", "savgol:7,3", "savgol:21,4", "gcv", "spline:0.5,1.5"}) {
    const Result<Derivation> derivation = parse_derivation(text);
    ASSERT_TRUE(derivation) << text;
    EXPECT_EQ(describe(*derivation), text);
  }
  for (const char* text : {"", "Central", "central:1", "butterworth", "butterworth:", "butterworth:0", "butterworth:-1", "savgol:7",
                           "savgol:6,3", "savgol:7,7", "savgol:7,1", "savgol:7,3,1", "gcv:2", "spline", "spline:1", "spline:0,1", "spline:1,-1", "savgol:7,x", "butterworth:6,"}) {
    EXPECT_FALSE(parse_derivation(text)) << text;
  }
}

}  // namespace
}  // namespace marey::test
