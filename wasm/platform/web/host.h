#pragma once

#include <cstddef>

/// A double-byte character set of marey_host_decode_letters().
enum class MareyLetters : int { Gbk = 0, ShiftJis = 1 };

/// What the page's JavaScript does for the program; web/host_library.js forwards each to `Module.host`
/// (web/src/host.ts). Text is UTF-8, given by its address and its size in bytes, and is only valid during the call.
/// What the JavaScript throws comes back as a std::runtime_error with its words.
extern "C" {
/// `use`: a FileUse.
void marey_host_ask_for_file(int use);
void marey_host_download(const char* name, size_t name_size, const char* bytes, size_t byte_count);
void marey_host_download_picture(const char* name, size_t name_size, const char* svg, size_t svg_size, int pixel_width);
void marey_host_load_sample(const char* id, size_t id_size);
void marey_host_stop_loading();
void marey_host_set_clipboard_text(const char* text, size_t text_size);
void marey_host_set_document_state(const char* name, size_t name_size, int dirty);
void marey_host_announce(const char* text, size_t text_size);
void marey_host_report_fault(const char* text, size_t text_size);
void marey_host_draw_after(double milliseconds);
void marey_host_store_preferences(const char* json, size_t json_size);
/// Copies the stored preferences into `buffer` when they fit into `capacity`; returns their size, 0 for none.
size_t marey_host_load_preferences(char* buffer, size_t capacity);
/// Bits: 1 dark, 2 reduced motion, 4 the keys of an Apple keyboard.
int marey_host_system_preferences();
void marey_host_set_mouse_cursor(const char* css_cursor, size_t css_cursor_size);
void marey_host_open_link(const char* url, size_t url_size);
/// The advance of a letter of the browser's fonts in pixels; `em` in pixels, `weight` 400 or 600.
double marey_host_measure_letter(unsigned code_point, double em, int weight);
/// Draws it into `coverage`, side x side bytes from 0 to 255, with its pen at pen_x, pen_y. A font that is still to be
/// loaded leaves it empty; marey_forget_letters tells when it has come.
void marey_host_draw_letter(unsigned code_point, double em, int weight, int side, int pen_x, int pen_y,
                            unsigned char* coverage);
/// The letters of two-byte codes, `byte_count` / 2 of them, by a set of MareyLetters; 0 where a code has none.
void marey_host_decode_letters(int set, const unsigned char* codes, size_t byte_count, char16_t* letters);
/// A text field has (1) or has lost (0) the keyboard; its caret stands at x, y with a line of `height`, in CSS pixels.
void marey_host_set_text_input(int wanted, float css_x, float css_y, float css_height);
}
