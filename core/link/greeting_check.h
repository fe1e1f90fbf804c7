// Tells a USARSim server from something else by the first things that it says.
#pragma once

#include <string_view>

namespace usar::link {

/// A line of the protocol is a type word of letters, digits and underscores, then nothing or a segment
/// (usarsim-protocol 1.1). One such line with a segment settles that this is USARSim. Until then control bytes, a known
/// greeting of another protocol (HTTP, SSH, SMTP …) or three lines of another shape settle that it is not; a single
/// garbled line does not. Plain class, one per connection, reset for the next.
class GreetingCheck {
public:
    static constexpr int patience_lines = 3;

    enum class Verdict { Unknown, Usarsim, Foreign };

    /// Raw bytes, before they are cut into lines: for what is not text at all.
    void takeBytes(std::string_view bytes);
    void takeLine(std::string_view line);
    Verdict verdict() const { return verdict_; }
    /// Something was said, and none of it looked right.
    bool suspicious() const { return verdict_ == Verdict::Foreign || (verdict_ == Verdict::Unknown && strange_ > 0); }
    void reset() { *this = {}; }

private:
    Verdict verdict_ = Verdict::Unknown;
    int strange_ = 0;
};

} // namespace usar::link
