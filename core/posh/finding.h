// What a reader or a check has to say about a plan: a code, a place and a sentence with the mend.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostics.h"
#include "core/posh/plan.h"

namespace usar::posh {

/// Errors of the text (1xx characters, 2xx grammar), of the plan as a whole (3xx), and warnings (4xx).
enum class Code : std::uint16_t {
    IllegalCharacter = 101,
    StringNeverClosed = 102,
    UnknownEscape = 103,
    MalformedNumber = 104,
    MalformedSymbol = 105,
    DollarWithoutName = 106,
    MalformedName = 107,
    NotAPlan = 201,
    UnexpectedToken = 202,
    EndOfFile = 203,
    TextAfterPlan = 204,
    UnknownForm = 205,
    LateDocumentation = 206,
    DocumentationStrings = 207,
    SecondCollection = 208,
    UnknownUnit = 209,
    NumberMissing = 210,
    NumberOutOfRange = 211,
    MisplacedPredicate = 212,
    BareNameAsValue = 213,
    PositionalAfterNamed = 214,
    ArgumentTwice = 215,
    ParameterTwice = 216,
    ParameterWithoutDefault = 217,
    EmptyList = 218,
    FractionalRetries = 219,
    DuplicateName = 301,
    ReferenceCycle = 302,
    NoCollection = 303,     ///< at binding: a fragment cannot run
    UnknownPrimitive = 304, ///< at binding, as the next and 307
    PrimitiveNamedAsForm = 305,
    FreeVariable = 306,
    WrongUse = 307,
    BadByte = 400,
    Fragment = 401,
    DuplicateDrive = 402,
    DuplicateElement = 403,
    NeverUsed = 404,
    OddSpace = 405,
    NameStartsWithDigit = 406,
    KeywordAsName = 407,
    NoElements = 408,
    ZeroRetries = 409,
    NeverReached = 410,
    MayFindNothing = 411,
    UndeclaredArgument = 412,
};

/// "E203", "W405".
std::string toText(Code code);
Severity severityOf(Code code);
/// Of characters or grammar: where it stands, a form is missing from the plan.
bool isUnreadable(Code code);

struct Finding {
    Code code = Code::UnexpectedToken;
    Spot at;
    std::string message;        ///< one sentence: what is wrong; what to write
    std::optional<Spot> opener; ///< where the parenthesis stands that was never closed
    bool operator==(const Finding&) const = default;
};

using Findings = std::vector<Finding>;

/// A word of the plan as a message names it: in quotes, and shortened, for a name may be as long as a plan.
std::string inQuotes(std::string_view word);

bool hasErrors(const Findings& findings);
/// No form is missing from the plan.
bool isReadable(const Findings& findings);

/// "3:14: error E202: expected …; write … (the parenthesis at 1:1 is open)".
std::string toText(const Finding& finding);

} // namespace usar::posh
