#include "core/campaign/runs/run_request.h"

#include <QUrl>

namespace usar::campaign {

QByteArray write(const RunRequest& request) {
    QByteArray line = QByteArray::number(request.number);
    for (const QString& argument : request.arguments)
        line += ' ' + QUrl::toPercentEncoding(argument, "/");
    return line + '\n';
}

RunRequest readRunRequest(const QByteArray& line) {
    const QByteArrayList words = line.chopped(line.endsWith('\n') ? 1 : 0).split(' ');
    RunRequest request{words.value(0).toInt(), {}};
    for (const QByteArray& word : words.mid(1))
        request.arguments << QUrl::fromPercentEncoding(word);
    return request;
}

QByteArray write(int number, const RunEnd& end) {
    // A run that crashes may leave a line without its end.
    return "\nended " + QByteArray::number(number) + (end.by_signal ? " by " : " ") + QByteArray::number(end.code) +
           '\n';
}

std::optional<RunEnd> takeRunEnd(QByteArray& written, int number) {
    const QByteArray begin = "\nended " + QByteArray::number(number) + ' ';
    const qsizetype at = written.lastIndexOf(begin);
    const qsizetype line_end = at < 0 ? -1 : written.indexOf('\n', at + 1);
    if (line_end < 0)
        return std::nullopt;
    QByteArray rest = written.mid(at + begin.size(), line_end - at - begin.size());
    const bool by_signal = rest.startsWith("by ");
    bool is_number = false;
    const RunEnd end{by_signal, rest.mid(by_signal ? 3 : 0).toInt(&is_number)};
    if (!is_number)
        return std::nullopt;
    written.truncate(at);
    return end;
}

} // namespace usar::campaign
