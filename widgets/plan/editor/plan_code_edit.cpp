#include "widgets/plan/editor/plan_code_edit.h"

#include <algorithm>

#include <QAbstractItemView>
#include <QKeyEvent>
#include <QMenu>
#include <QScrollBar>
#include <QStandardItemModel>
#include <QTextBlock>
#include <QTextDocument>

#include "core/posh/language/token.h"
#include "core/posh/model/keyword.h"
#include "widgets/messages/completion_delegate.h"
#include "widgets/plan/plan_parts.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"
#include "widgets/style/tool_button.h"

namespace usar::widgets {

namespace {

constexpr int letters_before_completion = 2;
constexpr int indent_blanks = 2;
constexpr int lamp_after_ms = 300;

bool isNamePart(QChar c) {
    return c.isLetterOrNumber() || c == u'_' || c == u'-' || c == u'.' || c == u'$';
}

} // namespace

PlanCodeEdit::PlanCodeEdit(QWidget* parent)
    : PlanTextEdit(parent)
    , completer_(new QCompleter(this))
    , help_beside_(new CompletionDelegate(this))
    , senses_(new QStandardItemModel(this))
    , acts_(new QStandardItemModel(this))
    , lamp_(makeToolButton(tr("Offers fixes for this (Alt+Return)"), this, QStringLiteral("lamp"))) {
    setReadOnly(false);
    setTextInteractionFlags(Qt::TextEditorInteraction);
    setTabChangesFocus(true);
    setAccessibleDescription(
        tr("F8 goes to the next error or warning, Alt+Return offers fixes, Ctrl+Space completes."));
    completer_->setWidget(this);
    completer_->setCaseSensitivity(Qt::CaseInsensitive);
    completer_->setFilterMode(Qt::MatchContains);
    completer_->setMaxVisibleItems(10);
    connect(completer_, qOverload<const QString&>(&QCompleter::activated), this, &PlanCodeEdit::insertCompletion);
    lamp_->hide();
    lamp_->setFocusPolicy(Qt::NoFocus); // Alt+Return does the same.
    connect(lamp_, &QToolButton::clicked, this, &PlanCodeEdit::fixesRequested);
    seen_revision_ = document()->revision();
    connect(document(), &QTextDocument::contentsChanged, this, &PlanCodeEdit::noticeChange);
    connect(this, &QPlainTextEdit::cursorPositionChanged, this, [this] {
        setLamp(false);
        matchParentheses();
    });
}

/// Emits textEdited for changes of the text only; coloring changes the contents as well.
void PlanCodeEdit::noticeChange() {
    if (document()->revision() == seen_revision_)
        return;
    seen_revision_ = document()->revision();
    setLamp(false);
    emit textEdited();
}

const std::string& PlanCodeEdit::planText() const {
    if (text_revision_ == document()->revision())
        return text_;
    QString raw = document()->toRawText(); // Unlike toPlainText, this keeps non-breaking spaces.
    raw.replace(QChar::ParagraphSeparator, u'\n');
    text_ = raw.toStdString();
    text_revision_ = document()->revision();
    return text_;
}

void PlanCodeEdit::resetText(std::string_view text) {
    setPlanText(text, {});
    document()->setModified(false);
}

int PlanCodeEdit::positionOf(std::size_t offset) const {
    return static_cast<int>(QString::fromUtf8(std::string_view(planText()).substr(0, offset)).size());
}

std::size_t PlanCodeEdit::cursorOffset() const {
    return static_cast<std::size_t>(document()->toRawText().left(textCursor().position()).toUtf8().size()) -
           // Each paragraph separator has three bytes of UTF-8, but counts as the one byte of LF.
           2U * static_cast<std::size_t>(textCursor().blockNumber());
}

void PlanCodeEdit::applyText(std::string_view wanted) {
    if (const std::vector<posh::Splice> edits = posh::difference(planText(), wanted); !edits.empty())
        applyEdits(edits);
}

void PlanCodeEdit::applyEdits(const std::vector<posh::Splice>& edits) {
    std::vector<std::pair<int, int>> places;
    for (const posh::Splice& edit : edits)
        places.emplace_back(positionOf(edit.begin), positionOf(edit.end));
    QTextCursor cursor(document());
    cursor.beginEditBlock();
    for (std::size_t i = edits.size(); i-- > 0;) { // Backward, so that the places before an edit stay right.
        cursor.setPosition(places[i].first);
        cursor.setPosition(places[i].second, QTextCursor::KeepAnchor);
        cursor.insertText(QString::fromUtf8(edits[i].text));
    }
    cursor.endEditBlock();
}

void PlanCodeEdit::setWords(const std::vector<PlanWord>& words) {
    senses_->clear();
    acts_->clear();
    for (const PlanWord& word : words) {
        auto* item = new QStandardItem(word.name);
        item->setData(word.help, CompletionDelegate::help_role);
        (word.is_sense ? senses_ : acts_)->appendRow(item);
    }
}

QString PlanCodeEdit::wordBeforeCursor() const {
    const QString line = textCursor().block().text();
    const int end = textCursor().positionInBlock();
    int begin = end;
    while (begin > 0 && isNamePart(line[begin - 1]))
        --begin;
    return line.mid(begin, end - begin);
}

/// True if the offset is inside a trigger or a goal.
bool PlanCodeEdit::asksSenses(std::size_t offset) const {
    const posh::TokenList list = posh::tokenize(planText());
    std::vector<bool> open; // True for each open list that is, or is inside, a list of senses.
    for (std::size_t i = 0; i + 1 < list.tokens.size() && list.tokens[i].at.offset < offset; ++i) {
        if (list.tokens[i].kind == posh::TokenKind::Close && !open.empty())
            open.pop_back();
        if (list.tokens[i].kind != posh::TokenKind::Open)
            continue;
        const posh::Keyword word = list.tokens[i + 1].keyword;
        open.push_back((!open.empty() && open.back()) || word == posh::Keyword::Trigger || word == posh::Keyword::Goal);
    }
    return !open.empty() && open.back();
}

void PlanCodeEdit::complete(bool asked) {
    const QString word = wordBeforeCursor();
    if (!asked && word.size() < letters_before_completion)
        return completer_->popup()->hide();
    QStandardItemModel* const model = asksSenses(cursorOffset()) ? senses_ : acts_;
    if (completer_->model() != model) {
        completer_->setModel(model);
        completer_->popup()->setItemDelegate(help_beside_); // A new model resets the popup's delegate.
    }
    completer_->setCompletionPrefix(word);
    const bool is_whole = completer_->completionCount() == 1 && completer_->currentCompletion() == word;
    if (completer_->completionCount() == 0 || (is_whole && !asked))
        return completer_->popup()->hide();
    completer_->popup()->setCurrentIndex(completer_->completionModel()->index(0, 0));
    QRect place = cursorRect();
    place.translate(viewport()->pos() - QPoint(fontMetrics().horizontalAdvance(word), 0));
    place.setWidth(std::max(360, width() / 2));
    completer_->complete(place);
}

void PlanCodeEdit::insertCompletion(const QString& word) {
    QTextCursor cursor = textCursor();
    const auto length = static_cast<int>(wordBeforeCursor().size());
    cursor.movePosition(QTextCursor::Left, QTextCursor::KeepAnchor, length);
    cursor.insertText(word);
    setTextCursor(cursor);
}

/// Indents the new line like the current one, and further if that leaves parentheses open.
void PlanCodeEdit::newLine() {
    const QString line = textCursor().block().text().left(textCursor().positionInBlock());
    const posh::TokenList list = posh::tokenize(line.toStdString());
    int depth = 0;
    for (const posh::Token& token : list.tokens)
        depth += token.kind == posh::TokenKind::Open ? 1 : token.kind == posh::TokenKind::Close ? -1 : 0;
    const auto text = std::ranges::find_if_not(line, [](QChar c) { return c.isSpace(); });
    const int blanks = static_cast<int>(text - line.begin());
    const int indent = std::max(0, blanks + std::clamp(depth, -2, 1) * indent_blanks);
    textCursor().insertText(u'\n' + QString(indent, u' '));
    ensureCursorVisible();
}

void PlanCodeEdit::toggleComment() {
    QTextCursor cursor = textCursor();
    QTextBlock block = document()->findBlock(cursor.selectionStart());
    const QTextBlock last = document()->findBlock(cursor.selectionEnd());
    const bool takes = block.text().trimmed().startsWith(u';');
    cursor.beginEditBlock();
    for (;; block = block.next()) {
        const auto mark = block.text().indexOf(u';');
        QTextCursor edit(block);
        if (takes && block.text().trimmed().startsWith(u';')) {
            edit.setPosition(block.position() + static_cast<int>(mark));
            const bool has_blank = block.text().mid(mark + 1).startsWith(u' ');
            edit.movePosition(QTextCursor::Right, QTextCursor::KeepAnchor, has_blank ? 2 : 1);
            edit.removeSelectedText();
        } else if (!takes) {
            edit.insertText(QStringLiteral("; "));
        }
        if (block == last)
            break;
    }
    cursor.endEditBlock();
}

void PlanCodeEdit::keyPressEvent(QKeyEvent* event) {
    const bool choosing = completer_->popup()->isVisible();
    const bool is_return = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (choosing && (is_return || event->key() == Qt::Key_Tab || event->key() == Qt::Key_Escape))
        return event->ignore(); // The completion list handles it.
    if (is_return && event->modifiers() == Qt::AltModifier)
        return emit fixesRequested();
    if (event->key() == Qt::Key_Space && event->modifiers() == Qt::ControlModifier)
        return complete(true);
    if (event->key() == Qt::Key_Slash && event->modifiers() == Qt::ControlModifier)
        return toggleComment();
    if (is_return && event->modifiers() == Qt::NoModifier)
        return newLine();
    const int before = document()->revision();
    PlanTextEdit::keyPressEvent(event);
    const bool typed = document()->revision() != before && !event->text().isEmpty() && event->text()[0].isPrint();
    if (typed && isNamePart(event->text()[0]))
        complete(false);
    else if (choosing && document()->revision() != before)
        complete(event->key() == Qt::Key_Backspace && !wordBeforeCursor().isEmpty());
}

/// Finds the parenthesis beside the cursor and its counterpart; a parenthesis without counterpart is marked as such.
void PlanCodeEdit::matchParentheses() {
    matched_.clear();
    unmatched_.clear();
    const QTextCursor cursor = textCursor();
    const bool at_open = document()->characterAt(cursor.position()) == u'(';
    if (at_open || document()->characterAt(cursor.position() - 1) == u')') {
        const posh::TokenList list = posh::tokenize(planText());
        const std::size_t offset = cursorOffset() - (at_open ? 0 : 1);
        std::vector<std::size_t> open;
        for (const posh::Token& token : list.tokens) {
            const bool closes = token.kind == posh::TokenKind::Close;
            if (token.kind == posh::TokenKind::Open)
                open.push_back(token.at.offset);
            if (!closes)
                continue;
            const bool is_it = token.at.offset == offset || (!open.empty() && open.back() == offset);
            if (is_it && !open.empty())
                matched_ = {positionOf(open.back()), positionOf(token.at.offset)};
            else if (is_it)
                unmatched_ = {positionOf(token.at.offset)};
            if (!open.empty())
                open.pop_back();
        }
        if (std::ranges::count(open, offset) > 0)
            unmatched_ = {positionOf(offset)};
    }
    mark();
}

void PlanCodeEdit::addMarks(QList<QTextEdit::ExtraSelection>& marks) const {
    const auto add = [&](int position, const QColor& color) {
        QTextCharFormat format;
        format.setForeground(inkOn(color));
        format.setBackground(color);
        QTextCursor cursor(document());
        cursor.setPosition(std::min(position, document()->characterCount() - 1));
        cursor.movePosition(QTextCursor::Right, QTextCursor::KeepAnchor);
        marks.append({cursor, format});
    };
    for (const int position : matched_)
        add(position, tokens().ok);
    for (const int position : unmatched_)
        add(position, tokens().danger);
}

void PlanCodeEdit::setLamp(bool on) {
    lamp_->setVisible(on);
    placeLamp();
}

void PlanCodeEdit::placeLamp() {
    const QRect line = cursorRect();
    const int size = minimum_target;
    const int scroll_bar = verticalScrollBar()->isVisible() ? verticalScrollBar()->width() : 0;
    lamp_->setGeometry(width() - scroll_bar - size - gap::tiny, viewport()->y() + line.center().y() - size / 2, size,
                       size);
}

void PlanCodeEdit::resizeEvent(QResizeEvent* event) {
    PlanTextEdit::resizeEvent(event);
    placeLamp();
}

void PlanCodeEdit::scrollContentsBy(int dx, int dy) {
    PlanTextEdit::scrollContentsBy(dx, dy);
    placeLamp();
}

PlanTextPane::PlanTextPane(QWidget* parent) : QWidget(parent) {
    edit_ = new PlanCodeEdit(this);
    edit_->setMinimumSize(120, 80);
    edit_->setContextMenuPolicy(Qt::CustomContextMenu);
    finding_ = makeLabel(this);
    finding_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    fix_ = makeToolButton(tr("Offers fixes for this (Alt+Return)"), this, QStringLiteral("lamp"));
    fix_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    fix_->setText(tr("Fix"));
    auto* const row = laidOut(new QHBoxLayout, gap::tiny, {finding_, fix_});
    row->setStretchFactor(finding_, 1);
    row->setAlignment(fix_, Qt::AlignTop);
    auto* const column = laidOut(new QVBoxLayout(this), {}, gap::tiny, {edit_});
    column->addLayout(row);
    column->setStretchFactor(edit_, 1);
    lamp_timer_.setSingleShot(true);
    lamp_timer_.setInterval(lamp_after_ms);
    connect(fix_, &QToolButton::clicked, this, &PlanTextPane::fixesRequested);
    connect(edit_, &PlanCodeEdit::fixesRequested, this, &PlanTextPane::fixesRequested);
    connect(&lamp_timer_, &QTimer::timeout, this, &PlanTextPane::pausedAtFinding);
}

void PlanTextPane::showFinding(bool fits_robot) {
    QString words = edit_->wordsAtCursor();
    if (words.isEmpty())
        words = (fits_robot ? tr("Nothing is wrong with the plan; it fits the robot.")
                            : tr("Nothing is wrong with the plan.")) +
                (edit_->notes().empty() ? QString() : tr(" F8 goes to a note."));
    finding_->setText(words);
    fix_->hide();
    lamp_timer_.start();
}

void PlanTextPane::setFixable(bool fixable) {
    edit_->setLamp(fixable);
    fix_->setVisible(fixable);
}

void PlanTextPane::showFixes(const std::vector<posh::QuickFix>& fixes) {
    auto* const menu = new QMenu(edit_);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (const posh::QuickFix& fix : fixes)
        connect(menu->addAction(QString::fromStdString(fix.title)), &QAction::triggered, this,
                [this, edits = fix.edits, revision = edit_->document()->revision()] {
                    if (revision != edit_->document()->revision())
                        return;
                    edit_->applyEdits(edits);
                    emit fixed();
                    edit_->setFocus();
                });
    menu->setActiveAction(menu->actions().front());
    menu->popup(edit_->viewport()->mapToGlobal(edit_->cursorRect().bottomLeft()));
}

} // namespace usar::widgets
