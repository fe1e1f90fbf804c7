#include "core/campaign/runs/run_request.h"

#include <QUrl>

namespace usar::campaign {

QByteArray writeRunRequest(const QStringList& arguments) {
    QByteArrayList words;
    for (const QString& argument : arguments)
        words << QUrl::toPercentEncoding(argument, "/");
    return words.join(' ') + '\n';
}

QStringList readRunRequest(const QByteArray& line) {
    QStringList arguments;
    const QByteArrayList words = line.trimmed().split(' ');
    for (const QByteArray& word : words)
        arguments << QUrl::fromPercentEncoding(word);
    return arguments;
}

QByteArray write(const RunEnd& end) {
    // A run that crashes may leave a line without its end.
    return (end.by_signal ? "\nended by " : "\nended ") + QByteArray::number(end.code) + '\n';
}

std::optional<RunEnd> takeRunEnd(QByteArray& written) {
    const qsizetype last = written.lastIndexOf("\nended ");
    if (last < 0 || !written.endsWith('\n'))
        return std::nullopt;
    const QByteArrayList words = written.mid(last).trimmed().split(' ');
    bool is_number = false;
    const RunEnd end{words.value(1) == "by", words.last().toInt(&is_number)};
    if (!is_number || words.size() != (end.by_signal ? 3 : 2))
        return std::nullopt;
    written.truncate(last);
    return end;
}

} // namespace usar::campaign
