// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/basics/film_end.h"

#include "ui/basics/film.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QProgressDialog>

namespace hygroloom {

void endInDialog(Film& film, QWidget* parent)
{
    film.finish();
    if (!film.busy()) { return; }
    QProgressDialog box(QCoreApplication::translate("hygroloom", "The film is being written."),
                        QCoreApplication::translate("hygroloom", "&Leave without It"), 0, 0, parent);
    box.setWindowTitle(QCoreApplication::translate("hygroloom", "Saving the film"));
    box.setWindowModality(Qt::WindowModal);
    box.setMinimumDuration(0);
    QEventLoop end;
    QObject::connect(&film, &Film::finished, &end, &QEventLoop::quit);
    QObject::connect(&film, &Film::failed, &end, &QEventLoop::quit);
    QObject::connect(&box, &QProgressDialog::canceled, &end, [&] {
        film.cancel();
        end.quit();
    });
    box.show();
    end.exec();
}

} // namespace hygroloom
