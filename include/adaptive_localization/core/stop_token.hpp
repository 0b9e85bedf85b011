// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <memory>

namespace adaptive_localization {

/// Thrown by work whose result is no longer wanted. Not a std::exception: nobody is to take it for
/// a failure on the way.
class Stopped {};

/// What long work asks now and then whether its result is still wanted (as C++20's
/// std::stop_token). Copies ask the same StopSource; one without a source never says stop.
class StopToken {
 public:
  /// Throws Stopped once the result is no longer wanted.
  void check() const {
    if (stopped_ && *stopped_) throw Stopped();
  }

 private:
  friend class StopSource;
  std::shared_ptr<const std::atomic<bool>> stopped_;
};

/// Says to all its tokens, in whichever thread, that the result is no longer wanted.
class StopSource {
 public:
  StopToken token() const {
    StopToken token;
    token.stopped_ = stopped_;
    return token;
  }
  void stop() { *stopped_ = true; }

 private:
  std::shared_ptr<std::atomic<bool>> stopped_{std::make_shared<std::atomic<bool>>(false)};
};

}  // namespace adaptive_localization
