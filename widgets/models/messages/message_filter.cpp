#include "widgets/models/messages/message_filter.h"

#include "core/base/text.h"

namespace usar::widgets {

std::optional<QRegularExpression> expressionOf(const QString& words) {
    if (words.size() < 3 || !words.startsWith(u'/') || !words.endsWith(u'/'))
        return std::nullopt;
    return QRegularExpression(words.mid(1, words.size() - 2), QRegularExpression::CaseInsensitiveOption);
}

MessageSieve::MessageSieve(const MessageFilter& filter)
    : filter_(filter)
    , words_(filter.words.toStdString())
    , name_(filter.name.toStdString())
    , expression_(expressionOf(filter.words)) {}

bool MessageSieve::passes(const MessageRow& row) const {
    if (filter_.connection && *filter_.connection != row.connection)
        return false;
    if (row.not_shown > 0)
        return true;
    return (!filter_.direction || *filter_.direction == row.direction) && (!filter_.only_trouble || row.trouble) &&
           filter_.types.shows(row.type) && (name_.empty() || hasName(row.text)) && hasWords(row);
}

bool MessageSieve::hasWords(const MessageRow& row) const {
    if (!expression_)
        return words_.isIn(row.text) || words_.isIn(row.type) || words_.isIn(row.note);
    const auto fits = [this](const std::string& text) {
        return expression_->match(QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()))).hasMatch();
    };
    return expression_->isValid() && (fits(row.text) || fits(row.type));
}

/// Searches the word after each "{Name ".
bool MessageSieve::hasName(std::string_view line) const {
    static const CaselessFinder key("{Name ");
    constexpr std::size_t key_size = 6;
    for (std::size_t at = key.placeIn(line); at != std::string_view::npos; at = key.placeIn(line)) {
        line.remove_prefix(at + key_size);
        std::string_view rest = line.substr(0, line.find('}'));
        if (name_.isIn(takeWord(rest)))
            return true;
    }
    return false;
}

} // namespace usar::widgets
