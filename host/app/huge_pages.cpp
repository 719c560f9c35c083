// Large blocks of memory in pages of two MiB where the system has them: a mesh is arrays of tens of megabytes, and in pages of
// four KiB a fourth of the time of a drawing passes in the kernel and in looking up addresses.
#include <cstddef>
#include <cstdlib>
#include <new>

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__)
#include <sys/mman.h>

namespace {

constexpr std::size_t page = std::size_t{2} << 20;

void* allocate(std::size_t size) noexcept {
  if (size < 2 * page || size > static_cast<std::size_t>(-1) - page) return std::malloc(size == 0 ? 1 : size);
  void* const block = std::aligned_alloc(page, (size + page - 1) / page * page);
  if (block != nullptr) static_cast<void>(madvise(block, size, MADV_HUGEPAGE));
  return block;
}

}  // namespace

void* operator new(std::size_t size) {
  while (true) {
    if (void* const block = allocate(size)) return block;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}

void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }

#endif
