#include "widgets/models/messages/message_filter.h"

#include "core/base/text.h"

namespace usar::widgets {
namespace {

unsigned char byteOf(char c) {
    return static_cast<unsigned char>(lowerCase(c));
}

} // namespace

CaselessFinder::CaselessFinder(std::string_view needle) : needle_(lowerCase(needle)) {
    shift_.fill(needle_.size());
    for (std::size_t i = 0; i + 1 < needle_.size(); ++i)
        shift_[byteOf(needle_[i])] = needle_.size() - 1 - i;
}

std::size_t CaselessFinder::placeIn(std::string_view text) const {
    if (needle_.empty())
        return 0;
    for (std::size_t end = needle_.size() - 1; end < text.size(); end += shift_[byteOf(text[end])]) {
        std::size_t back = 0;
        while (back < needle_.size() && lowerCase(text[end - back]) == needle_[needle_.size() - 1 - back])
            ++back;
        if (back == needle_.size())
            return end + 1 - needle_.size();
    }
    return std::string_view::npos;
}

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
        return expression_->match(QString::fromUtf8(text)).hasMatch();
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
