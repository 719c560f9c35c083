// A function that takes a few host instructions must be inlined, or the host's registers are spilled around its call.
// Without optimisation inlining gains nothing, and with sanitizers, which check every access in every copy, it multiplies
// compile time and gains no speed: those builds call the functions.
#pragma once

#if defined(__clang__)
#if __has_feature(address_sanitizer) || __has_feature(memory_sanitizer) || __has_feature(thread_sanitizer)
#define SIGHTLINE_INLINE
#endif
#elif defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SIGHTLINE_INLINE
#endif
#if !defined(SIGHTLINE_INLINE) && !defined(__OPTIMIZE__)
#define SIGHTLINE_INLINE
#endif
#if !defined(SIGHTLINE_INLINE)
#define SIGHTLINE_INLINE [[gnu::always_inline]]
#endif
