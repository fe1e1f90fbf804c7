#include "core/mission/files/json_positions.h"

#include <algorithm>

#include <QJsonArray>
#include <QJsonDocument>

namespace usar::mission {

namespace {

class Walker {
public:
    explicit Walker(const QByteArray& text) : text_(text) {}

    std::vector<JsonKey> take() {
        value({});
        return std::move(keys_);
    }

private:
    char here() const { return at_ < text_.size() ? text_[at_] : '\0'; }

    void skipSpace() {
        while (at_ < text_.size() && QByteArrayView(" \t\r\n").contains(text_[at_]))
            ++at_;
    }

    QString string() {
        const qsizetype start = at_++;
        while (at_ < text_.size() && text_[at_] != '"')
            at_ += text_[at_] == '\\' ? 2 : 1;
        ++at_;
        return QJsonDocument::fromJson('[' + text_.mid(start, at_ - start) + ']').array().at(0).toString();
    }

    void value(const QString& path) {
        skipSpace();
        if (here() == '{')
            members(path);
        else if (here() == '[')
            elements(path);
        else if (here() == '"')
            string();
        else
            while (at_ < text_.size() && !QByteArrayView(",]} \t\r\n").contains(text_[at_]))
                ++at_;
        skipSpace();
    }

    void members(const QString& path) {
        do {
            ++at_; // The brace or the comma.
            skipSpace();
            if (here() != '"')
                break;
            JsonKey key;
            key.key_offset = at_;
            key.parent = path;
            key.name = string();
            skipSpace();
            ++at_; // The colon.
            skipSpace();
            key.value_offset = at_;
            keys_.push_back(key);
            value(key.path());
        } while (here() == ',');
        ++at_;
    }

    void elements(const QString& path) {
        int index = 0;
        do {
            ++at_;
            skipSpace();
            if (here() == ']')
                break;
            value(path + '[' + QString::number(index++) + ']');
        } while (here() == ',');
        ++at_;
    }

    const QByteArray& text_;
    qsizetype at_ = 0;
    std::vector<JsonKey> keys_;
};

} // namespace

std::vector<JsonKey> jsonKeys(const QByteArray& valid_json) {
    return Walker(valid_json).take();
}

QString LineWalk::at(qsizetype offset) {
    for (; at_ < std::min(offset, text_.size()); ++at_) {
        const auto byte = static_cast<unsigned char>(text_[at_]);
        if (byte == '\n') {
            ++line_;
            column_ = 1;
        } else if ((byte & 0xc0) != 0x80) { // Not the middle of a character.
            column_ += byte >= 0xf0 ? 2 : 1;
        }
    }
    return QString("%1:%2").arg(line_).arg(column_);
}

QString lineAndColumn(const QByteArray& text, qsizetype offset) {
    return LineWalk(text).at(offset);
}

} // namespace usar::mission
