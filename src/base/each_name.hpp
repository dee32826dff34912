// SPDX-License-Identifier: Apache-2.0
#pragma once

/// CROSSGRAIN_EACH(call, object, a, b) is call(object, a) call(object, b), for at most 64 names.
#define CROSSGRAIN_EACH(call, object, ...) CROSSGRAIN_SCAN_64(CROSSGRAIN_NEXT(call, object, __VA_ARGS__))

// A macro does not expand inside itself: each NEXT leaves a call that the next scan expands.
#define CROSSGRAIN_NEXT(call, object, name, ...) \
  call(object, name) __VA_OPT__(CROSSGRAIN_NEXT_LATER CROSSGRAIN_NOTHING()()(call, object, __VA_ARGS__))
#define CROSSGRAIN_NEXT_LATER() CROSSGRAIN_NEXT
#define CROSSGRAIN_NOTHING()
#define CROSSGRAIN_SCAN_64(...) \
  CROSSGRAIN_SCAN_16(CROSSGRAIN_SCAN_16(CROSSGRAIN_SCAN_16(CROSSGRAIN_SCAN_16(__VA_ARGS__))))
#define CROSSGRAIN_SCAN_16(...) \
  CROSSGRAIN_SCAN_4(CROSSGRAIN_SCAN_4(CROSSGRAIN_SCAN_4(CROSSGRAIN_SCAN_4(__VA_ARGS__))))
#define CROSSGRAIN_SCAN_4(...) CROSSGRAIN_SCAN(CROSSGRAIN_SCAN(CROSSGRAIN_SCAN(CROSSGRAIN_SCAN(__VA_ARGS__))))
#define CROSSGRAIN_SCAN(...) __VA_ARGS__
