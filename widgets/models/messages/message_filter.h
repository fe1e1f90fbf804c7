// Filter for lines of traffic, and the search that applies it to a hundred thousand of them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include <QRegularExpression>
#include <QString>

#include "widgets/models/messages/message_row.h"

namespace usar::widgets {

/// Searches for one needle with Horspool's algorithm; bytes beyond ASCII must match exactly. An empty needle is found
/// in every text.
class CaselessFinder {
public:
    explicit CaselessFinder(std::string_view needle);

    /// True if the needle occurs in `text`.
    bool isIn(std::string_view text) const { return placeIn(text) != std::string_view::npos; }
    /// Returns the offset, in bytes, of the first occurrence, or npos.
    std::size_t placeIn(std::string_view text) const;
    /// True if the needle is empty, so that every text matches.
    bool empty() const { return needle_.empty(); }

private:
    std::string needle_;                   ///< in lower case
    std::array<std::size_t, 256> shift_{}; ///< by the byte at the end of the window, in either case
};

/// Choice of types by name, as in MessageRow::type: either the listed ones are hidden (types never seen before are
/// shown), or only the listed ones are shown. The default shows all.
struct TypeChoice {
    std::set<std::string, std::less<>> types{};
    bool only_these = false;
    /// True if lines of this type are shown.
    bool shows(std::string_view type) const { return types.contains(type) == only_these; }
    bool operator==(const TypeChoice&) const = default;
};

/// All conditions must hold; a default filter lets every row pass.
struct MessageFilter {
    /// Contained in type, text or note, ignoring case; "/…/" is a regular expression on type and text; empty: all.
    QString words{};
    std::optional<Direction> direction{}; ///< nullopt: both
    TypeChoice types{};
    QString name{};            ///< part of the name of a sensor, effecter, package or robot on the line; empty: all
    bool only_trouble = false; ///< only rows with diagnostics
    std::optional<ConnectionId> connection{}; ///< as MessageRow::connection; nullopt: all
    bool operator==(const MessageFilter&) const = default;
};

/// Returns the regular expression between the slashes, which may be invalid; nullopt if `words` is plain text.
std::optional<QRegularExpression> expressionOf(const QString& words);

/// Tests rows against a filter; made once for many rows. An invalid regular expression lets no row pass.
class MessageSieve {
public:
    explicit MessageSieve(const MessageFilter& filter);
    /// A row that stands for omitted lines passes every filter except the one for its connection.
    bool passes(const MessageRow& row) const;

private:
    /// True if the row contains the words or matches the expression; also without words.
    bool hasWords(const MessageRow& row) const;
    /// True if a "{Name …}" on the line has the wanted part in it.
    bool hasName(std::string_view line) const;

    MessageFilter filter_;
    CaselessFinder words_;
    CaselessFinder name_;
    std::optional<QRegularExpression> expression_;
};

} // namespace usar::widgets
