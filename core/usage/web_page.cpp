#include "core/usage/web_page.h"

#include <QHash>
#include <QRegularExpression>

namespace usar::usage {

namespace {

/// Calls `replacement` for each match and puts its result in the place of it.
template <class Replacement>
QString replaced(const QString& text, const QRegularExpression& pattern, Replacement replacement) {
    QString result;
    qsizetype done = 0;
    for (auto matches = pattern.globalMatch(text); matches.hasNext();) {
        const QRegularExpressionMatch match = matches.next();
        result += text.mid(done, match.capturedStart() - done) + replacement(match);
        done = match.capturedEnd();
    }
    return result + text.mid(done);
}

/// The words of a piece of HTML.
QString plainText(const QString& html) {
    static const QRegularExpression tag("<[^>]*>");
    QString text = html;
    text.remove(tag);
    return text.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&amp;", "&");
}

const QRegularExpression& headingPattern() {
    static const QRegularExpression pattern("<h([1-6])>(.*?)</h\\1>", QRegularExpression::DotMatchesEverythingOption);
    return pattern;
}

QString withAnchors(const QString& body) {
    QHash<QString, int> used;
    return replaced(body, headingPattern(), [&used](const QRegularExpressionMatch& heading) {
        const QString anchor = anchorOf(plainText(heading.captured(2)));
        const int before = used[anchor]++;
        const QString id = before == 0 ? anchor : anchor + '-' + QString::number(before);
        return QString("<h%1 id=\"%2\">%3</h%1>").arg(heading.captured(1), id, heading.captured(2));
    });
}

QString withPages(const QString& body) {
    static const QRegularExpression link("href=\"([^\":]+)\\.md(#[^\"]*)?\"");
    return replaced(body, link, [](const QRegularExpressionMatch& found) {
        return "href=\"" + found.captured(1) + ".html" + found.captured(2) + '"';
    });
}

} // namespace

QString anchorOf(const QString& heading) {
    QString anchor;
    for (const QChar letter : heading.trimmed().toLower()) {
        if (letter == ' ')
            anchor += '-';
        else if (letter.isLetterOrNumber() || letter == '-' || letter == '_')
            anchor += letter;
    }
    return anchor;
}

QString webPage(const QString& body, const QString& root) {
    const QString title = plainText(headingPattern().match(body).captured(2));
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
           title.toHtmlEscaped() + "</title>\n<link rel=\"stylesheet\" href=\"" + root +
           "page.css\">\n</head>\n<body>\n<nav><a href=\"" + root +
           "README.html\">USAR Mission Control</a> <a href=\"" + root +
           "resources/docs/manual.html\">Manual</a> <a href=\"" + root +
           "resources/docs/tasks/README.html\">Tasks</a></nav>\n<main>\n" + withPages(withAnchors(body)) +
           "</main>\n</body>\n</html>\n";
}

} // namespace usar::usage
