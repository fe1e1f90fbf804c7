#include "widgets/bars/result_card.h"

#include <QVBoxLayout>

#include "widgets/style/form_parts.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

ResultCard::ResultCard(QWidget* parent) : QFrame(parent) {
    setProperty("role", "strip");
    setAccessibleName(tr("Result"));
    named(folder_, tr("Open folder"), tr("Opens the folder with all files of this scan"));
    named(open_picture_, tr("Open picture"), tr("Opens the picture of the map with its marks"));
    named(again_, tr("Fly again"), tr("Starts the same behavior with the same area and parameters once more"));
    named(compare_, tr("Compare"), tr("Shows the figures of this run beside those of others"));
    named(close_, tr("Close the result"), tr("Closes this card; the files stay, and Notifications names them"));
    close_->setIcon(icon(QStringLiteral("clear")));
    makeFlat(close_);
    lay();
    connect(close_, &QToolButton::clicked, this, &QWidget::hide);
    connect(folder_, &QPushButton::clicked, this, [this] { emit folderRequested(folderOf(outcome_)); });
    connect(open_picture_, &QPushButton::clicked, this, [this] { emit pictureRequested(pictureOf(outcome_)); });
    connect(again_, &QPushButton::clicked, this, &ResultCard::flyAgainRequested);
    connect(compare_, &QPushButton::clicked, this, [this] { emit compareRequested(summaryOf(outcome_)); });
    hide();
}

void ResultCard::lay() {
    named(picture_, tr("Picture of the map"), tr("The map from above, with its marks"));
    named(relief_, tr("3D picture of the map"), tr("The map from the south-east, with the path and the marks"));
    title_->setFont(themeFont(FontRole::Body, QFont::DemiBold));
    reason_->setWordWrap(true);
    figures_->setWordWrap(true);
    figures_->setTextFormat(Qt::RichText);
    auto* const buttons = laidOut(new QHBoxLayout, gap::small, {folder_, open_picture_, again_, compare_});
    buttons->addStretch(1);
    for (QPushButton* const button : {folder_, open_picture_, again_, compare_})
        button->setFocusPolicy(Qt::TabFocus); // A click leaves the keys to the map.
    auto* const column = laidOut(new QVBoxLayout, gap::tiny, {title_, reason_, figures_});
    column->addLayout(buttons);
    auto* const row = laidOut(new QHBoxLayout(this), {gap::medium, gap::small, gap::small, gap::small}, gap::medium,
                              {picture_, relief_});
    row->addLayout(column, 1);
    row->addWidget(close_, 0, Qt::AlignTop);
}

void ResultCard::tell(const MissionOutcome& outcome) {
    outcome_ = outcome;
    title_->setText(titleOf(outcome));
    reason_->setText(outcome.reason);
    setAccessibleDescription(title_->text() + QStringLiteral(". ") + outcome.reason);
    setPictures({}, {});
    folder_->setVisible(!folderOf(outcome).isEmpty());
    open_picture_->setVisible(!pictureOf(outcome).isEmpty());
    compare_->setVisible(!summaryOf(outcome).isEmpty());
    setCanFlyAgain(true);
    showFigures();
    show();
}

void ResultCard::setPictures(const QImage& map, const QImage& relief) {
    picture_->setPixmap(QPixmap::fromImage(map));
    relief_->setPixmap(QPixmap::fromImage(relief));
    showPictures();
}

void ResultCard::showPictures() {
    int room_px = width() - minimumSizeHint().width();
    for (QLabel* const label : {picture_, relief_}) {
        const bool has_picture = !label->pixmap(Qt::ReturnByValue).isNull();
        if (has_picture)
            room_px -= picture_px.width() + gap::medium;
        label->setVisible(has_picture && room_px >= 0);
    }
}

void ResultCard::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    showPictures();
}

void ResultCard::showFigures() {
    const QString nbsp = QStringLiteral("&nbsp;"); // Keeps each figure on one line.
    QStringList texts;
    QStringList helps;
    for (const OutcomeFigure& figure : figuresOf(outcome_)) {
        const QString name = figure.name.toHtmlEscaped().replace(u' ', nbsp);
        texts << QStringLiteral("%1 <b>%2</b>").arg(name, figure.value.toHtmlEscaped().replace(u' ', nbsp));
        helps << figure.name + QStringLiteral(": ") + figure.help;
    }
    figures_->setText(texts.join(QStringLiteral(" · ")));
    figures_->setToolTip(helps.join(u'\n'));
}

} // namespace usar::widgets
