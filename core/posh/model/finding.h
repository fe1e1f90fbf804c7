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
    IllegalCharacter = 101,        ///< a character that no word can have
    StringNeverClosed = 102,       ///< a string without its closing quote
    UnknownEscape = 103,           ///< a backslash before a character that it cannot escape
    MalformedNumber = 104,         ///< such as 1.2.3, or a number that does not fit into 64 bits
    MalformedSymbol = 105,         ///< a quote that no name follows
    DollarWithoutName = 106,       ///< a dollar sign that no name follows
    MalformedName = 107,           ///< such as a name that ends with a dot
    NotAPlan = 201,                ///< the text does not begin with a parenthesis, or is too long
    UnexpectedToken = 202,         ///< something else must be here
    EndOfFile = 203,               ///< the text ends before the plan does
    TextAfterPlan = 204,           ///< text after the parenthesis that closes the plan
    UnknownForm = 205,             ///< a form that is none of C, AP, AD, DC and documentation
    LateDocumentation = 206,       ///< documentation after another form
    DocumentationStrings = 207,    ///< documentation with fewer or more than three strings
    SecondCollection = 208,        ///< a plan can have only one
    UnknownUnit = 209,             ///< a word that is not a unit, or a rate as a time limit
    NumberMissing = 210,           ///< a unit without a number
    NumberOutOfRange = 211,        ///< a negative time, or a rate of zero
    MisplacedPredicate = 212,      ///< a comparison that does not follow its value
    BareNameAsValue = 213,         ///< a name that is neither a symbol nor a text nor a parameter
    PositionalAfterNamed = 214,    ///< an argument without a name after one with a name
    ArgumentTwice = 215,           ///< two arguments with the same name
    ParameterTwice = 216,          ///< two parameters with the same name
    ParameterWithoutDefault = 217, ///< every parameter needs a default
    EmptyList = 218,               ///< a pattern without steps, or a collection without drives
    FractionalRetries = 219,       ///< retries that are not a whole number
    DuplicateName = 301,           ///< two forms with the same name
    ReferenceCycle = 302,          ///< a form that contains itself
    NoCollection = 303,            ///< found when binding to a robot: a fragment cannot run
    UnknownPrimitive = 304,        ///< the robot has no such sense or act; found when binding, like 305 and 307
    PrimitiveNamedAsForm = 305,    ///< a form with the name of an act of the robot
    FreeVariable = 306,            ///< a variable that its form does not declare
    WrongUse = 307,                ///< arguments that a sense or act does not take, or a sense used as an act
    BadByte = 400,                 ///< a byte that is not valid UTF-8
    Fragment = 401,                ///< no drive collection
    DuplicateDrive = 402,          ///< two drives with the same name
    DuplicateElement = 403,        ///< two elements of a competence with the same name
    NeverUsed = 404,               ///< a form that nothing calls
    OddSpace = 405,                ///< white space that only looks like a blank
    NameStartsWithDigit = 406,     ///< other readers refuse such names
    KeywordAsName = 407,           ///< a word of the language used as a name
    NoElements = 408,              ///< a competence without elements
    ZeroRetries = 409,             ///< means no limit here, but never to other readers
    NeverReached = 410,            ///< a member after one that is always ready
    MayFindNothing = 411,          ///< a competence whose elements may all be unready
    UndeclaredArgument = 412,      ///< an argument that the called form does not declare
};

/// "E203", "W405".
/// E stands for errors, W for warnings.
std::string toText(Code code);
/// Warning for 4xx, otherwise Error.
Severity severityOf(Code code);
/// Returns whether the code is an error in characters or grammar. The form that has such an error is missing from the
/// plan.
bool isUnreadable(Code code);

/// One error or warning about a plan.
struct Finding {
    Code code = Code::UnexpectedToken;
    /// Line and column in the text of the plan.
    Spot at{};
    std::string message{};        ///< one sentence, "<problem>; <what to write>"
    std::optional<Spot> opener{}; ///< place of the parenthesis that was never closed; only for Code::EndOfFile
    bool operator==(const Finding&) const = default;
};

/// Errors and warnings about one plan.
using Findings = std::vector<Finding>;

/// Formats a word of the plan for a message: in quotes, cut after about 40 bytes, control characters as blanks.
std::string inQuotes(std::string_view word);

/// Returns whether at least one finding is an error; warnings alone do not keep a plan from running.
bool hasErrors(const Findings& findings);
/// Returns whether all forms of the text are in the plan.
bool isReadable(const Findings& findings);

/// Formats a finding: "3:14: error E202: expected …; write … (the parenthesis at 1:1 is open)".
std::string toText(const Finding& finding);

} // namespace usar::posh
