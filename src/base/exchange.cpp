// SPDX-License-Identifier: Apache-2.0
#include "base/exchange.hpp"

#include <algorithm>

namespace crossgrain {

void append_bytes(Bytes& message, std::span<const std::byte> bytes) {
  message.insert(message.end(), bytes.begin(), bytes.end());
}

bool any(Exchange& exchange, bool mine) {
  const std::vector<char> all = gathered_value<char>(exchange, mine ? 1 : 0);
  return std::find(all.begin(), all.end(), 1) != all.end();
}

double running_sum(Exchange& exchange, std::span<const double> terms) {
  double sum = 0;
  const Exchange::Received received{exchange.rank() - 1, std::as_writable_bytes(std::span(&sum, 1))};
  if (exchange.rank() > 0) exchange.swap({}, {&received, 1});
  for (const double term : terms) sum += term;
  const Exchange::Sent sent{exchange.rank() + 1, std::as_bytes(std::span(&sum, 1))};
  if (exchange.rank() + 1 < exchange.ranks()) exchange.swap({&sent, 1}, {});
  return gathered_value(exchange, sum).back();
}

}  // namespace crossgrain
