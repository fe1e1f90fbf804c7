#include "core/campaign/plan/shell_words.h"

namespace usar::campaign {

Result<QStringList> shellWords(const QString& command) {
    QStringList words;
    QString word;
    bool in_word = false; // An empty word in quotes is a word, too.
    QChar quote;
    for (qsizetype i = 0; i < command.size(); ++i) {
        const QChar c = command[i];
        if (!quote.isNull() && c == quote) {
            quote = QChar();
        } else if (c == u'\\' && quote != u'\'' && i + 1 < command.size()) {
            word += command[++i];
            in_word = true;
        } else if (quote.isNull() && (c == u'\'' || c == u'"')) {
            quote = c;
            in_word = true;
        } else if (quote.isNull() && c.isSpace()) {
            if (in_word)
                words << word;
            word.clear();
            in_word = false;
        } else {
            word += c;
            in_word = true;
        }
    }
    if (!quote.isNull())
        return failure("a quote has no end", command.toStdString(), "The result line is damaged; fly the run anew");
    if (in_word)
        words << word;
    return words;
}

} // namespace usar::campaign
