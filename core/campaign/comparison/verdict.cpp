#include "core/campaign/comparison/verdict.h"

namespace usar::campaign {

const char* wordOf(Verdict verdict) {
    switch (verdict) {
    case Verdict::Better:
        return "better";
    case Verdict::Worse:
        return "worse";
    case Verdict::Equal:
        return "equal";
    case Verdict::NotWorse:
        return "not worse";
    case Verdict::Undecided:
        return "undecided";
    }
    return "";
}

Verdict verdictOn(const Evidence& evidence) {
    const auto& [low, high] = evidence.gain;
    if (!evidence.is_enough)
        return Verdict::Undecided;
    if (low > evidence.margin && evidence.is_significant)
        return Verdict::Better;
    if (high < -evidence.margin && evidence.is_significant)
        return Verdict::Worse;
    return low >= -evidence.margin && high <= evidence.margin ? Verdict::Equal : Verdict::Undecided;
}

bool isNotWorse(const Evidence& evidence) {
    return evidence.is_enough && evidence.gain.low >= -evidence.margin;
}

} // namespace usar::campaign
