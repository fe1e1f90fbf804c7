// How recorded traces are laid out in bytes; shared by encoder and reader.
//
// A file is the magic, then frames: a length (varint, of what follows), a kind and a body. Cycles are coded as what
// differs from the cycle before, by operations on its list of events; key frames lean on nothing before them. A sense
// whose answer is remembered is coded without it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/posh/trace_event.h"

namespace usar::posh::trace_codec {

constexpr std::string_view magic = "USARPOSH1\n"; ///< with the version
constexpr int cycles_per_key = 256;
constexpr std::size_t longest_frame = std::size_t{1} << 24;

enum class Frame : std::uint8_t {
    Plan = 'P',   ///< the text of the plan that the frames behind it are of
    Key = 'K',    ///< cycle, time (zigzag), operations on an empty list; texts are numbered anew
    Delta = 'D',  ///< time step less the step before (zigzag), operations on the cycle before
    Between = 'B' ///< events behind the cycle, as a list of new events; touches nothing that deltas lean on
};

/// An operation is a varint: the count times four, plus one of these.
enum class Operation : std::uint64_t {
    Copy = 0,   ///< so many events are as before
    Change = 1, ///< the next event is as before but for what a mask names
    Insert = 2, ///< a new event
    Skip = 3,   ///< so many events of before are gone
};

constexpr std::uint8_t payload_changes = 1;
constexpr std::uint8_t detail_changes = 2;
constexpr std::uint8_t flags_change = 4;
constexpr std::uint8_t kind_changes = 8;
constexpr std::uint8_t text_changes = 16;

/// One event with the number of its text; 0 for none.
struct Entry {
    TraceRecord record;
    std::uint32_t text = 0;
    bool operator==(const Entry&) const = default;
};

inline std::uint64_t zigzag(std::int64_t number) {
    return (static_cast<std::uint64_t>(number) << 1) ^ static_cast<std::uint64_t>(number >> 63);
}
inline std::int64_t unzigzag(std::uint64_t number) {
    return static_cast<std::int64_t>(number >> 1) ^ -static_cast<std::int64_t>(number & 1);
}

void appendVarint(std::string& out, std::uint64_t number);
/// What of eight bytes is left without the zeros before and behind it, after a byte that counts them.
void appendBits(std::string& out, std::uint64_t bits);

/// Takes values off the front of untrusted bytes; after the first that is not there, all are 0.
class Bytes {
public:
    explicit Bytes(std::string_view bytes) : bytes_(bytes) {}
    std::uint64_t varint();
    std::uint64_t bits();
    std::uint8_t byte();
    std::string_view text(std::uint64_t length);
    bool empty() const { return at_ == bytes_.size(); }
    bool failed() const { return failed_; }
    std::size_t used() const { return at_; }

private:
    std::string_view bytes_;
    std::size_t at_ = 0;
    bool failed_ = false;
};

} // namespace usar::posh::trace_codec
