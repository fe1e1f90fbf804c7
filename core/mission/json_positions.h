// Where the keys of a JSON text stand, which QJsonDocument does not tell: for errors with line and column.
#pragma once

#include <vector>

#include <QByteArray>
#include <QString>

namespace usar::mission {

/// One key of an object. Offsets count bytes from the start of the text.
struct JsonKey {
    QString parent; ///< path of the object it is in: "" outermost, "area"; elements of arrays are "list[0]"
    QString name;
    qsizetype key_offset = 0;
    qsizetype value_offset = 0;
    QString path() const { return parent.isEmpty() ? name : parent + '.' + name; }
};

/// Every key in the order of the text, double ones too. The text must be one that QJsonDocument has taken.
std::vector<JsonKey> jsonKeys(const QByteArray& valid_json);

/// "line:column" of bytes that are asked for in the order of the text, both from 1, in one walk over it. Columns count
/// characters (of UTF-16), not bytes. The text outlives it.
class LineWalk {
public:
    explicit LineWalk(const QByteArray& text) : text_(text) {}
    QString at(qsizetype offset);

private:
    const QByteArray& text_;
    qsizetype at_ = 0;
    int line_ = 1;
    int column_ = 1;
};

/// The same for a single byte.
QString lineAndColumn(const QByteArray& text, qsizetype offset);

} // namespace usar::mission
