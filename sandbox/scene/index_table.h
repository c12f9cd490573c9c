#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace sandbox {

/// splitmix64's finish: all bits of the result depend on all bits of `x`.
constexpr std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ x >> 30U) * 0xbf58476d1ce4e5b9U;
    x = (x ^ x >> 27U) * 0x94d049bb133111ebU;
    return x ^ x >> 31U;
}

/// Finds, by their hashes, indices into a list that its owner keeps. An open hash: a std::unordered_map allocates for
/// every element, which takes several times as long where there are a million.
class IndexTable {
  public:
    explicit IndexTable(std::size_t expected = 0) { resize(expected); }

    /// The index put in under this hash for which `is_it` holds; or `next`, which is put in.
    template <class IsIt> std::uint32_t find_or_put(std::uint64_t hash, std::uint32_t next, const IsIt &is_it) {
        const auto low = static_cast<std::uint32_t>(hash);
        for (std::size_t at = low & mask_;; at = (at + 1) & mask_) {
            const Slot &slot = slots_[at];
            if (slot.index == none) {
                put({low, next});
                return next;
            }
            if (slot.hash == low && is_it(slot.index)) {
                return slot.index;
            }
        }
    }

  private:
    static constexpr std::uint32_t none = 0xffffffffU;
    struct Slot {
        std::uint32_t hash = 0, index = none;
    };
    std::vector<Slot> slots_; ///< a power of 2, at most half of them taken
    std::size_t mask_ = 0, taken_ = 0;

    void resize(std::size_t elements) {
        std::size_t size = 16;
        while (size < 2 * elements) {
            size *= 2;
        }
        const std::vector<Slot> old = std::exchange(slots_, std::vector<Slot>(size));
        mask_ = size - 1;
        for (const Slot &slot : old) {
            if (slot.index != none) {
                insert(slot);
            }
        }
    }
    void put(const Slot &slot) {
        if (++taken_ > slots_.size() / 2) {
            resize(2 * taken_);
        }
        insert(slot);
    }
    void insert(const Slot &slot) {
        std::size_t at = slot.hash & mask_;
        while (slots_[at].index != none) {
            at = (at + 1) & mask_;
        }
        slots_[at] = slot;
    }
};

} // namespace sandbox
