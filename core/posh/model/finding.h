// Errors and warnings about a plan: a code, a place and a sentence that says how to fix it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostics.h"
#include "core/posh/model/plan.h"

namespace usar::posh {

/// Errors in the text (1xx for characters, 2xx for grammar), errors in the plan as a whole (3xx), and warnings (4xx).
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
    NoCollection = 303,     ///< found when binding to a robot: a fragment cannot run
    UnknownPrimitive = 304, ///< found when binding to a robot, like 305 and 307
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
/// Returns whether the code is an error in characters or grammar. The form that has such an error is missing from the
/// plan.
bool isUnreadable(Code code);

/// One error or warning about a plan.
struct Finding {
    Code code = Code::UnexpectedToken;
    Spot at{};
    std::string message{};        ///< one sentence, "<problem>; <what to write>"
    std::optional<Spot> opener{}; ///< place of the parenthesis that was never closed; only for Code::EndOfFile
    bool operator==(const Finding&) const = default;
};

using Findings = std::vector<Finding>;

/// Formats a word of the plan for a message: in quotes, cut after about 40 bytes, control characters as blanks.
std::string inQuotes(std::string_view word);

bool hasErrors(const Findings& findings);
/// Returns whether all forms of the text are in the plan.
bool isReadable(const Findings& findings);

/// Formats a finding: "3:14: error E202: expected …; write … (the parenthesis at 1:1 is open)".
std::string toText(const Finding& finding);

} // namespace usar::posh
