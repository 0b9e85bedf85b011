// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmock/gmock.h>

#include "eval/bag_writer.hpp"
#include "eval/log_reader.hpp"
#include "support/temp_folder.hpp"

namespace adaptive_localization {

/// Tests that write a bag and read it.
class BagLog : public testing::Test {
 protected:
  BagLog() { request_.file = folder_.file("a.bag"); }

  void expectRejected(const std::string& why) const {
    EXPECT_THAT([this] { readLog(request_); },
                testing::ThrowsMessage<std::invalid_argument>(
                    testing::AllOf(testing::HasSubstr(request_.file), testing::HasSubstr(why))));
  }

  /// Odometry every 0.1 s from 100 to 103 s at 1 m/s, scans between, the laser's mount at 100 s.
  void writeDrive(const std::string& scan_topic = "/scan") const {
    BagWriter bag(request_.file);
    bag.laserTransform(100.0);
    for (int i = 0; i <= 30; ++i) {
      const double stamp = 100.0 + 0.1 * i;
      bag.odometryTransform(stamp, {stamp - 100.0, 0.0, 0.0});
      bag.pose("/truth", stamp, {stamp - 90.0, 1.0, 0.5});
      if (i < 30) bag.scan(scan_topic, stamp + 0.05);
    }
  }

  TempFolder folder_;
  LogRequest request_;
};

}  // namespace adaptive_localization
