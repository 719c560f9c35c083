// What an instruction does in a few host instructions has to be made in place of every call, or the registers of the host are spilled
// around it. Where nothing is optimised that gains nothing, and with sanitizers, which check every access in every copy, such code
// takes several times as long to compile and is no faster: there the same functions are called.
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
