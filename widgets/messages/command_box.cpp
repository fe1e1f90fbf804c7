#include "widgets/messages/command_box.h"

#include <algorithm>

#include <QAbstractItemView>
#include <QFrame>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>

#include "core/base/text.h"
#include "core/protocol/command_grammar.h"
#include "widgets/messages/completion_delegate.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {
namespace {

/// Paints a wave two pixels high, as in other editors.
void paintWave(QPainter& painter, double from_px, double to_px, double base_px) {
    constexpr double step_px = 2.0;
    QPainterPath wave(QPointF(from_px, base_px));
    bool up = true;
    for (double x = from_px + step_px; x <= std::max(to_px, from_px + 3 * step_px); x += step_px, up = !up)
        wave.lineTo(x, base_px - (up ? 2.0 : 0.0));
    painter.drawPath(wave);
}

constexpr int idle_ms = 500;                ///< time without typing after which the line is checked
constexpr int from_role = Qt::UserRole + 1; ///< role of the first byte that a completion replaces

/// Makes a sentence of a diagnostic, because the grammar's messages have no final period.
QString sentence(const Diagnostic& diagnostic) {
    const QString text = QString::fromStdString(diagnostic.message);
    return CommandBox::tr("Column %1: %2")
        .arg(diagnostic.offset + 1)
        .arg(text.endsWith(u'.') || text.endsWith(u'?') ? text : text + u'.');
}

/// Returns the text to append to a completion: a blank after a word, the closing brace after a value.
QString ending(const std::string& before, std::string_view completed) {
    const std::size_t brace = before.rfind('{');
    const bool inside = brace != std::string::npos && before.find('}', brace) == std::string::npos;
    const bool is_value = inside && before.find(' ', brace) != std::string::npos;
    if (completed.ends_with('}') || completed.ends_with(' '))
        return {};
    return is_value ? QStringLiteral("} ") : QStringLiteral(" ");
}

} // namespace

void LineHistory::setLines(const QStringList& lines) {
    lines_ = lines.mid(std::max<qsizetype>(0, lines.size() - limit));
    endWalk();
}

void LineHistory::add(const QString& line) {
    lines_.removeAll(line);
    lines_ << line;
    if (lines_.size() > limit)
        lines_.removeFirst();
    endWalk();
}

bool LineHistory::walk(qsizetype step) {
    for (qsizetype at = at_.value_or(lines_.size()) + step; at >= 0 && at < lines_.size(); at += step)
        if (lines_[at].contains(typed_, Qt::CaseInsensitive)) {
            at_ = at;
            return true;
        }
    return false;
}

std::optional<QString> LineHistory::older(const QString& typed) {
    if (!at_)
        typed_ = typed;
    return walk(-1) ? std::optional(lines_[*at_]) : std::nullopt;
}

std::optional<QString> LineHistory::newer() {
    if (!at_)
        return std::nullopt;
    if (walk(1))
        return lines_[*at_];
    endWalk();
    return typed_;
}

CommandLine::CommandLine(QWidget* parent) : QLineEdit(parent) {
    setFont(codeFont());
    setMinimumHeight(minimum_target);
    setClearButtonEnabled(true);
}

void CommandLine::setDiagnostics(const Diagnostics& diagnostics) {
    if (diagnostics == diagnostics_)
        return;
    diagnostics_ = diagnostics;
    update();
}

std::size_t CommandLine::wordEnd(std::size_t offset) const {
    const std::string bytes = text().toStdString();
    std::size_t end = std::min(offset, bytes.size());
    while (end < bytes.size() && !isSpace(bytes[end]) && bytes[end] != '}' && (bytes[end] != '{' || end == offset))
        ++end;
    return end;
}

void CommandLine::paintEvent(QPaintEvent* event) {
    QLineEdit::paintEvent(event);
    if (diagnostics_.empty())
        return;
    const QByteArray bytes = text().toUtf8();
    const QFontMetricsF metrics(font());
    const auto advance = [&](std::size_t byte) {
        return metrics.horizontalAdvance(QString::fromUtf8(bytes.left(static_cast<qsizetype>(byte))));
    };
    const double zero_px = cursorRect().center().x() - advance(cursorByte());
    const double base_px = cursorRect().bottom() + 1.0;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(rect().adjusted(3, 0, -3, 0));
    for (const Diagnostic& diagnostic : diagnostics_) {
        painter.setPen(QPen(diagnostic.severity == Severity::Error ? tokens().danger : tokens().caution, 1.2));
        const std::size_t end = wordEnd(diagnostic.offset);
        paintWave(painter, zero_px + advance(diagnostic.offset), zero_px + advance(end), base_px);
    }
}

CommandBox::CommandBox(QWidget* parent) : QWidget(parent) {
    auto* column = laidOut(new QVBoxLayout(this), {gap::tiny, gap::tiny, gap::tiny, gap::tiny}, 2);
    auto* row = laidOut(new QHBoxLayout, gap::tiny, {line_, send_});
    row->setStretchFactor(line_, 1);
    column->addLayout(row);
    column->addWidget(complaint_);
    send_->setMinimumHeight(minimum_target);
    send_->setToolTip(tr("Sends the line as it is (Enter)"));
    complaint_->setWordWrap(true);
    complaint_->setTextFormat(Qt::PlainText);
    complaint_->setAccessibleName(tr("What is wrong with the command"));
    complaint_->hide();
    line_->setAccessibleName(tr("Raw command"));
    setUpCompleter();
    idle_.setSingleShot(true);
    idle_.setInterval(idle_ms);
    connect(&idle_, &QTimer::timeout, this, [this] { check(false); });
    connect(line_, &QLineEdit::textChanged, this, [this] {
        line_->setDiagnostics({});
        complaint_->hide();
        sent_anyway_.clear();
        idle_.start();
    });
    connect(line_, &QLineEdit::textEdited, this, &CommandBox::takeEdit);
    connect(send_, &QPushButton::clicked, this, &CommandBox::send);
    line_->installEventFilter(this);
    setTarget({}, {});
}

void CommandBox::setUpCompleter() {
    completer_->setModel(completions_);
    completer_->setWidget(line_);
    completer_->setCompletionMode(QCompleter::UnfilteredPopupCompletion);
    completer_->setMaxVisibleItems(10);
    completer_->popup()->setFrameShape(QFrame::StyledPanel);
    completer_->popup()->setItemDelegate(new CompletionDelegate(completer_->popup()));
    completer_->popup()->setAccessibleName(tr("Completions"));
    // The open list gets all keys first, and its own filter, the completer's, hands them to the line past any filter.
    completer_->popup()->installEventFilter(this);
    connect(completer_, QOverload<const QModelIndex&>::of(&QCompleter::activated), this, &CommandBox::accept);
}

void CommandBox::setTarget(const QString& name, const QString& refusal) {
    refusal_ = refusal;
    line_->setPlaceholderText(name.isEmpty() ? tr("Raw command: no connection")
                                             : tr("Raw command to %1 (Up: history, Ctrl+Space: words)").arg(name));
    line_->setToolTip(
        tr("A line as the server reads it, such as DRIVE {Left 1.0} {Right 1.0}. Enter sends it, Tab completes it, and "
           "Up and Down step through the lines sent before that contain the typed text."));
}

void CommandBox::complain(Severity severity, const QString& sentence) {
    setRole(complaint_, severity == Severity::Error ? "danger" : "caution");
    complaint_->setText((severity == Severity::Error ? QStringLiteral("✕ ") : QStringLiteral("⚠ ")) + sentence);
    complaint_->show();
}

void CommandBox::takeEdit() {
    history_.endWalk();
    const std::string text = line_->text().toStdString();
    if (trimmed(text).empty())
        return completer_->popup()->hide();
    openCompletions();
}

void CommandBox::openCompletions() {
    const std::string text = line_->text().toStdString();
    const std::size_t cursor = line_->cursorByte();
    completions_->clear();
    for (const protocol::Completion& completion : protocol::completionsAt(text, cursor)) {
        if (text.substr(completion.from, cursor - completion.from) == completion.text)
            continue; // It is already there.
        auto* item = new QStandardItem(QString::fromStdString(completion.text));
        item->setData(QString::fromStdString(completion.help), CompletionDelegate::help_role);
        item->setData(static_cast<qulonglong>(completion.from), from_role);
        completions_->appendRow(item);
    }
    if (completions_->rowCount() == 0)
        return completer_->popup()->hide();
    completer_->complete(QRect(0, 0, std::min(line_->width(), 520), line_->height()));
}

bool CommandBox::popupOpen() const {
    return completer_->popup()->isVisible();
}

bool CommandBox::chosenInPopup() const {
    return popupOpen() && completer_->popup()->selectionModel()->hasSelection();
}

bool CommandBox::eventFilter(QObject* watched, QEvent* event) {
    if ((watched == line_ || watched == completer_->popup()) && event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (takeKey(key->key(), key->modifiers())) {
            event->accept();
            return true;
        }
        if (watched == line_ && chosenInPopup() && (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter)) {
            event->ignore(); // The completer handles it then.
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

bool CommandBox::takeKey(int key, Qt::KeyboardModifiers modifiers) {
    switch (key) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (chosenInPopup() || modifiers.testFlag(Qt::ControlModifier))
            return false;
        send();
        return true;
    case Qt::Key_Tab: {
        if (!popupOpen())
            return false;
        const QModelIndex current = completer_->popup()->currentIndex();
        accept(current.isValid() ? current : completer_->completionModel()->index(0, 0));
        return true;
    }
    case Qt::Key_Up:
    case Qt::Key_Down:
        if (popupOpen())
            return false;
        if (const auto line = key == Qt::Key_Up ? history_.older(line_->text()) : history_.newer())
            line_->setText(*line);
        return true;
    case Qt::Key_Space:
        if (!modifiers.testFlag(Qt::ControlModifier))
            return false;
        openCompletions();
        return true;
    default:
        return false;
    }
}

void CommandBox::accept(const QModelIndex& index) {
    const std::string completion = index.data().toString().toStdString();
    const auto from = static_cast<std::size_t>(index.data(from_role).toULongLong());
    const std::string text = line_->text().toStdString();
    const std::size_t cursor = line_->cursorByte();
    const std::string before = text.substr(0, from);
    const QString head = QString::fromStdString(before + completion) + ending(before, completion);
    line_->setText(head + QString::fromStdString(std::string(trimmed(std::string_view(text).substr(cursor)))));
    line_->setCursorPosition(static_cast<int>(head.size()));
    completer_->popup()->hide();
    QTimer::singleShot(0, this, &CommandBox::openCompletions); // After the completer has finished.
}

Diagnostics CommandBox::check(bool all) {
    Diagnostics diagnostics = protocol::checkCommand(line_->text().toStdString());
    if (!all && line_->hasFocus())
        std::erase_if(diagnostics, [this](const Diagnostic& diagnostic) {
            return line_->wordEnd(diagnostic.offset) >= line_->cursorByte() || popupOpen();
        });
    line_->setDiagnostics(diagnostics);
    if (diagnostics.empty())
        return diagnostics;
    const Diagnostic& worst = *std::ranges::max_element(diagnostics, {}, &Diagnostic::severity);
    complain(worst.severity, sentence(worst));
    return diagnostics;
}

void CommandBox::send() {
    completer_->popup()->hide();
    const QString text = line_->text().trimmed();
    if (text.isEmpty())
        return;
    if (!refusal_.isEmpty())
        return complain(Severity::Error, refusal_);
    const Diagnostics diagnostics = check(true);
    const bool wrong = std::ranges::any_of(
        diagnostics, [](const Diagnostic& diagnostic) { return diagnostic.severity == Severity::Error; });
    if (wrong && sent_anyway_ != text) {
        sent_anyway_ = text;
        complaint_->setText(complaint_->text() + tr(" Enter again sends it as it is."));
        return;
    }
    history_.add(text);
    line_->clear();
    emit sendRequested(text);
    // A warning stays visible although the line has been sent.
    if (!diagnostics.empty() && !wrong)
        complain(Severity::Warning, tr("Sent. %1").arg(sentence(diagnostics.front())));
}

} // namespace usar::widgets
