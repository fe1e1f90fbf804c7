// Positions of the keys in a JSON text, which QJsonDocument does not provide; needed for errors with line and column.
#pragma once

#include <vector>

#include <QByteArray>
#include <QString>

namespace usar::mission {

/// One key of an object. Offsets count bytes from the start of the text.
struct JsonKey {
    QString parent; ///< path of the enclosing object: "" for the outermost, "area"; elements of arrays are "list[0]"
    QString name;
    qsizetype key_offset = 0;
    qsizetype value_offset = 0;
    QString path() const { return parent.isEmpty() ? name : parent + '.' + name; }
};

/// All keys in the order of the text, including duplicates. The text must be one that QJsonDocument has accepted.
std::vector<JsonKey> jsonKeys(const QByteArray& valid_json);

/// Turns byte offsets into "line:column", both from 1, in one walk over the text, which must outlive this object.
/// Columns count UTF-16 units, not bytes.
class LineWalk {
public:
    explicit LineWalk(const QByteArray& text) : text_(text) {}
    /// `offset` must not be smaller than in the call before.
    QString at(qsizetype offset);

private:
    const QByteArray& text_;
    qsizetype at_ = 0;
    int line_ = 1;
    int column_ = 1;
};

/// "line:column" of a single byte, both from 1.
QString lineAndColumn(const QByteArray& text, qsizetype offset);

} // namespace usar::mission
