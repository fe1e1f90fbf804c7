// Filter for lines of traffic, and the test that applies it to a hundred thousand of them.
#pragma once

#include <optional>
#include <set>
#include <string>

#include <QRegularExpression>
#include <QString>

#include "widgets/models/messages/caseless_finder.h"
#include "widgets/models/messages/message_row.h"

namespace usar::widgets {

/// Choice of types by name, as in MessageRow::type: either the listed ones are hidden (types never seen before are
/// shown), or only the listed ones are shown. The default shows all.
struct TypeChoice {
    std::set<std::string, std::less<>> types{};
    bool only_these = false;
    /// True if lines of this type are shown.
    bool shows(std::string_view type) const { return types.contains(type) == only_these; }
    bool showsAll() const { return types.empty() && !only_these; }
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
    bool hasWords(const MessageRow& row) const;
    bool hasName(std::string_view line) const;

    MessageFilter filter_;
    CaselessFinder words_;
    CaselessFinder name_;
    std::optional<QRegularExpression> expression_;
};

} // namespace usar::widgets
