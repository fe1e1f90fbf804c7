#include "widgets/plan/plan_text_edit.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QScopedValueRollback>
#include <QScrollBar>
#include <QSyntaxHighlighter>
#include <QTextBlock>
#include <QToolTip>

#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr double mark_px = 14.0;

/// Colors comments, strings, keywords and numbers. Strings may span several lines.
class PlanHighlighter : public QSyntaxHighlighter {
public:
    using QSyntaxHighlighter::QSyntaxHighlighter;

protected:
    void highlightBlock(const QString& text) override {
        bool in_string = previousBlockState() == 1;
        int at = 0;
        while (at < text.size()) {
            const int start = at;
            if (in_string || text[at] == u'"') {
                at += in_string ? 0 : 1;
                in_string = !skipString(text, at);
                setFormat(start, at - start, lineColor(LineFamily::Answer, currentTheme()));
            } else if (text[at] == u';' || text[at] == u'#') {
                setFormat(start, static_cast<int>(text.size()) - start, tokens().text_muted);
                break;
            } else if (isWordPart(text[at])) {
                while (at < text.size() && isWordPart(text[at]))
                    ++at;
                colorWord(text.mid(start, at - start), start);
            } else {
                ++at;
            }
        }
        setCurrentBlockState(in_string ? 1 : 0);
    }

private:
    static bool isWordPart(QChar c) { return c.isLetterOrNumber() || QStringLiteral("_-.$+").contains(c); }

    /// Moves `at` after the end of the string; returns false if the line ends first.
    static bool skipString(const QString& text, int& at) {
        for (; at < text.size(); ++at) {
            if (text[at] == u'\\')
                ++at;
            else if (text[at] == u'"')
                return ++at, true;
        }
        at = static_cast<int>(text.size());
        return false;
    }

    void colorWord(const QString& word, int start) {
        static const QStringList keywords{
            "c",        "ap",   "ad",      "dc",   "rdc",   "sdc",     "srdc",    "drives", "documentation",
            "elements", "goal", "trigger", "vars", "hours", "minutes", "seconds", "hz",     "pm",
            "ticks",    "none", "nil",     "true", "false"};
        const int length = static_cast<int>(word.size());
        bool is_number = false;
        word.toDouble(&is_number);
        if (is_number)
            setFormat(start, length, lineColor(LineFamily::Range, currentTheme()));
        else if (keywords.contains(word.toLower()))
            setFormat(start, length, tokens().accent);
        else if (word.startsWith(u'$'))
            setFormat(start, length, lineColor(LineFamily::Sensor, currentTheme()));
    }
};

/// The strip with the line numbers, painted by its editor.
class Gutter : public QWidget {
public:
    explicit Gutter(PlanTextEdit* edit) : QWidget(edit), edit_(edit) {}
    QSize sizeHint() const override { return {edit_->gutterWidth(), 0}; }

protected:
    void paintEvent(QPaintEvent* event) override { edit_->paintGutter(event); }

private:
    PlanTextEdit* edit_;
};

bool isError(const posh::Finding& finding) {
    return severityOf(finding.code) == Severity::Error;
}

} // namespace

PlanTextEdit::PlanTextEdit(QWidget* parent) : QPlainTextEdit(parent), gutter_(new Gutter(this)) {
    setReadOnly(true);
    setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    setLineWrapMode(QPlainTextEdit::NoWrap);
    setFont(codeFont());
    setTabStopDistance(4.0 * QFontMetricsF(codeFont()).horizontalAdvance(u' '));
    setAccessibleName(tr("Text of the plan"));
    setAccessibleDescription(tr("F8 goes to the next error or warning, Shift+F8 to the previous one."));
    onThemeChange(this, [this, highlighter = new PlanHighlighter(document())] {
        highlighter->rehighlight();
        mark();
    });
    connect(this, &QPlainTextEdit::updateRequest, gutter_, [this](const QRect& area, int dy) {
        dy ? gutter_->scroll(0, dy) : gutter_->update(0, area.y(), gutter_->width(), area.height());
    });
    connect(this, &QPlainTextEdit::cursorPositionChanged, this, [this] {
        if (!quiet_)
            emit placeEntered(textCursor().blockNumber() + 1,
                              columnOf(textCursor().block().text(), textCursor().positionInBlock()));
    });
}

void PlanTextEdit::setPlanText(std::string_view text, const posh::Findings& findings, std::vector<PlanNote> notes) {
    const QScopedValueRollback quiet(quiet_, true);
    running_lines_.clear();
    shown_ = {};
    setPlainText(editorText(text));
    setFindings(findings, std::move(notes));
}

void PlanTextEdit::setFindings(const posh::Findings& findings, std::vector<PlanNote> notes) {
    findings_ = findings;
    notes_ = std::move(notes);
    remarks_.clear();
    for (const PlanNote& note : notes_)
        remarks_.push_back({Kind::Note, note.at, note.words});
    for (const posh::Finding& finding : findings_)
        remarks_.push_back({isError(finding) ? Kind::Error : Kind::Warning, finding.at,
                            QString::fromStdString(posh::toText(finding))});
    remark_lines_.clear();
    for (const Remark& remark : remarks_) {
        Kind& worst = remark_lines_[static_cast<int>(remark.at.line)];
        worst = std::max(worst, remark.kind);
    }
    setViewportMargins(gutterWidth(), 0, 0, 0);
    mark();
}

void PlanTextEdit::setRunningLines(const std::set<int>& lines) {
    if (lines == running_lines_)
        return;
    running_lines_ = lines;
    mark();
}

void PlanTextEdit::showPlace(const posh::Spot& spot) {
    shown_ = spot;
    if (spot.line > 0) {
        const QScopedValueRollback quiet(quiet_, true);
        QTextCursor cursor = cursorAt(spot);
        cursor.setPosition(cursor.selectionStart());
        setTextCursor(cursor);
        scrollToShown();
    }
    mark();
}

/// Lines are shown from their beginning if possible.
void PlanTextEdit::scrollToShown() {
    horizontalScrollBar()->setValue(0);
    ensureCursorVisible();
}

QTextCursor PlanTextEdit::cursorAt(const posh::Spot& spot) const {
    const QTextBlock block = document()->findBlockByNumber(static_cast<int>(spot.line) - 1);
    QTextCursor cursor(block.isValid() ? block : document()->lastBlock());
    const TextRange range = rangeOf(spot, cursor.block().text());
    cursor.setPosition(cursor.block().position() + range.start);
    cursor.setPosition(cursor.position() + range.length, QTextCursor::KeepAnchor);
    return cursor;
}

void PlanTextEdit::mark() {
    QList<QTextEdit::ExtraSelection> marks;
    QColor tint = tokens().accent;
    tint.setAlphaF(0.22f);
    for (const int line : running_lines_)
        if (const QTextBlock block = document()->findBlockByNumber(line - 1); block.isValid()) {
            QTextCharFormat format;
            format.setBackground(tint);
            format.setProperty(QTextFormat::FullWidthSelection, true);
            marks.append({QTextCursor(block), format});
        }
    for (const Remark& remark : remarks_) {
        QTextCharFormat format;
        format.setUnderlineStyle(remark.kind == Kind::Error ? QTextCharFormat::WaveUnderline
                                                            : QTextCharFormat::DotLine);
        format.setUnderlineColor(remark.kind == Kind::Error     ? tokens().danger
                                 : remark.kind == Kind::Warning ? tokens().caution
                                                                : tokens().accent);
        marks.append({cursorAt(remark.at), format});
    }
    if (shown_.line > 0) {
        QTextCharFormat format;
        format.setBackground(tokens().accent);
        format.setForeground(inkOn(tokens().accent));
        marks.append({cursorAt(shown_), format});
    }
    addMarks(marks);
    setExtraSelections(marks);
    gutter_->update();
}

void PlanTextEdit::nextFinding(bool backward) {
    if (remarks_.empty())
        return;
    std::set<std::pair<int, int>> places;
    for (const Remark& remark : remarks_)
        places.emplace(static_cast<int>(remark.at.line), cursorAt(remark.at).selectionStart());
    const std::pair here(textCursor().blockNumber() + 1, textCursor().position());
    const auto after = places.upper_bound(here);
    const auto from = places.lower_bound(here);
    const auto place = backward ? (from == places.begin() ? std::prev(places.end()) : std::prev(from))
                                : (after == places.end() ? places.begin() : after);
    QTextCursor cursor = textCursor();
    cursor.setPosition(place->second);
    setTextCursor(cursor);
    centerCursor();
}

const posh::Finding* PlanTextEdit::findingAtCursor() const {
    const auto line = static_cast<std::uint32_t>(textCursor().blockNumber() + 1);
    const posh::Finding* found = nullptr;
    for (const posh::Finding& finding : findings_)
        if (finding.at.line == line && (!found || (isError(finding) && !isError(*found))))
            found = &finding;
    return found;
}

QString PlanTextEdit::wordsAtCursor() const {
    if (const posh::Finding* const finding = findingAtCursor())
        return QString::fromStdString(posh::toText(*finding));
    const auto line = static_cast<std::uint32_t>(textCursor().blockNumber() + 1);
    for (const PlanNote& note : notes_)
        if (note.at.line == line)
            return note.words;
    if (findings_.empty())
        return {};
    const auto errors = std::ranges::count_if(findings_, isError);
    return tr("Errors: %1, warnings: %2. F8 in the text goes to the next one.")
        .arg(errors)
        .arg(std::ssize(findings_) - errors);
}

QString PlanTextEdit::toolTipAt(int line) const {
    QStringList findings;
    QStringList notes;
    for (const Remark& remark : remarks_)
        if (static_cast<int>(remark.at.line) == line)
            (remark.kind == Kind::Note ? notes : findings) << remark.words;
    return (findings + notes).join(u'\n');
}

int PlanTextEdit::gutterWidth() const {
    const auto digits = QString::number(std::max(100, blockCount())).size();
    return static_cast<int>(mark_px + double(digits) * fontMetrics().horizontalAdvance(u'0') + 2 * gap::tiny);
}

void PlanTextEdit::paintGutter(QPaintEvent* event) {
    QPainter painter(gutter_);
    painter.fillRect(event->rect(), tokens().raised);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font());
    for (QTextBlock block = firstVisibleBlock(); block.isValid(); block = block.next()) {
        const QRectF row = blockBoundingGeometry(block).translated(contentOffset());
        if (row.top() > event->rect().bottom())
            break;
        const int line = block.blockNumber() + 1;
        if (running_lines_.contains(line))
            painter.fillRect(QRectF(0.0, row.top(), 4.0, row.height()), tokens().accent);
        if (const auto remark = remark_lines_.find(line); remark != remark_lines_.end())
            paintRemarkMark(painter, {3.0, row.top(), mark_px, row.height()}, remark->second);
        painter.setPen(tokens().text_muted);
        painter.drawText(QRectF(0.0, row.top(), gutter_->width() - gap::tiny, row.height()),
                         Qt::AlignRight | Qt::AlignVCenter, QString::number(line));
    }
}

void PlanTextEdit::paintRemarkMark(QPainter& painter, const QRectF& place, Kind kind) const {
    const QPointF middle = place.center();
    painter.setBrush(Qt::NoBrush);
    if (kind == Kind::Error) {
        painter.setPen(QPen(tokens().danger, 2.0));
        painter.drawLine(middle + QPointF(-4, -4), middle + QPointF(4, 4));
        painter.drawLine(middle + QPointF(-4, 4), middle + QPointF(4, -4));
    } else if (kind == Kind::Warning) {
        painter.setPen(QPen(tokens().caution, 1.5));
        const QPointF corners[] = {middle + QPointF(0, -5), middle + QPointF(5, 4), middle + QPointF(-5, 4)};
        painter.drawPolygon(corners, 3);
    } else {
        painter.setPen(QPen(tokens().accent, 1.5));
        painter.drawEllipse(middle, 5.0, 5.0);
        painter.drawLine(middle + QPointF(0, -0.5), middle + QPointF(0, 2.5));
        painter.drawPoint(middle + QPointF(0, -2.5));
    }
}

void PlanTextEdit::resizeEvent(QResizeEvent* event) {
    const bool was_seen = cursorRect().top() >= 0 && cursorRect().bottom() <= event->oldSize().height();
    QPlainTextEdit::resizeEvent(event);
    const QRect inside = contentsRect();
    gutter_->setGeometry(inside.left(), inside.top(), gutterWidth(), inside.height());
    if (shown_.line > 0) // It may have been set while there was no room.
        scrollToShown();
    else if (was_seen) // A growing label below must not hide the text at the cursor.
        ensureCursorVisible();
}

void PlanTextEdit::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_F8)
        return nextFinding(event->modifiers() & Qt::ShiftModifier);
    QPlainTextEdit::keyPressEvent(event);
}

bool PlanTextEdit::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* const help = static_cast<QHelpEvent*>(event);
        const int line = cursorForPosition(viewport()->mapFrom(this, help->pos())).blockNumber() + 1;
        QToolTip::showText(help->globalPos(), toolTipAt(line), this);
        return true;
    }
    return QPlainTextEdit::event(event);
}

} // namespace usar::widgets
