// Which lines of traffic are shown, and the sieve that decides it for a hundred thousand of them.
#pragma once

#include <optional>
#include <set>
#include <string>

#include <QRegularExpression>
#include <QString>

#include "widgets/models/caseless_finder.h"
#include "widgets/models/message_row.h"

namespace usar::widgets {

/// Types by name, as in MessageRow::type. Either the listed ones are hidden (then a type never seen before is shown),
/// or only the listed ones are shown. The default shows all.
struct TypeChoice {
    std::set<std::string, std::less<>> types{};
    bool only_these = false;
    bool shows(std::string_view type) const { return types.contains(type) == only_these; }
    bool showsAll() const { return types.empty() && !only_these; }
    bool operator==(const TypeChoice&) const = default;
};

/// All must fit; a default filter lets everything through.
struct MessageFilter {
    QString words{}; ///< in type, text or note, whatever the case; "/…/" is a regular expression; empty for all
    std::optional<Direction> direction{};
    TypeChoice types{};
    QString name{}; ///< part of the name of a sensor, effecter, package or robot on the line; empty for all
    bool only_trouble = false;
    std::optional<int> connection{}; ///< MessageRow::connection
    bool operator==(const MessageFilter&) const = default;
};

/// The expression between the slashes; nothing where `words` are plain.
std::optional<QRegularExpression> expressionOf(const QString& words);

/// Built once for a pass over many rows. An expression that is not valid lets nothing through.
class MessageSieve {
public:
    explicit MessageSieve(const MessageFilter& filter);
    /// Always true for a row that stands for lines left out: that is said, whatever is searched.
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
