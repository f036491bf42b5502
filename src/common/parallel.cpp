// SPDX-License-Identifier: BSD-3-Clause
#include "goal_alignment/common/parallel.h"

#include <algorithm>
#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>
#include <exception>
#include <thread>
#include <vector>

namespace goal_alignment {

void inParallel(std::size_t count, int threads, const std::function<void(std::size_t)>& work) {
  const std::size_t most = std::min<std::size_t>(std::thread::hardware_concurrency(), count);
  const std::size_t side_by_side = std::min<std::size_t>(std::max(threads, 1), most);
  if (side_by_side <= 1) {
    for (std::size_t i = 0; i < count; ++i)
      work(i);
    return;
  }
  std::vector<std::exception_ptr> thrown(count);
  boost::asio::thread_pool pool(side_by_side);
  for (std::size_t i = 0; i < count; ++i) {
    boost::asio::post(pool, [&, i] {
      try {
        work(i);
      } catch (...) {
        thrown[i] = std::current_exception();
      }
    });
  }
  pool.join();
  for (const std::exception_ptr& exception : thrown) {
    if (exception) std::rethrow_exception(exception);
  }
}

}  // namespace goal_alignment
