// Whether a server that has been connected to speaks the protocol at all.
#pragma once

#include <string_view>

namespace usar::link {

/// Distinguishes a USARSim server from another kind of server by the first bytes that it sends. A line of the protocol
/// is a type word of letters, digits and underscores, followed by nothing or by a segment (protocol.md 1.1). One such
/// line with a segment proves that this is USARSim. Until then, control bytes, a known greeting of another protocol
/// (HTTP, SSH, SMTP …) or three lines of another shape prove that it is not; a single garbled line does not. Plain
/// class, one per connection, reset for the next.
class GreetingCheck {
public:
    enum class Verdict { Unknown, Usarsim, Foreign };

    /// Takes raw bytes before they are cut into lines; recognizes binary data.
    void takeBytes(std::string_view bytes);
    /// Takes one line without its line end.
    void takeLine(std::string_view line);
    /// Unknown at first; once it is Usarsim or Foreign it stays so until reset().
    Verdict verdict() const { return verdict_; }
    /// True if something odd was received and nothing has proved that this is USARSim.
    bool suspicious() const { return verdict_ == Verdict::Foreign || (verdict_ == Verdict::Unknown && strange_ > 0); }
    void reset() { *this = {}; }

private:
    Verdict verdict_ = Verdict::Unknown;
    int strange_ = 0;
};

} // namespace usar::link
