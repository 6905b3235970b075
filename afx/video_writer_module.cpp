// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
//
// The module afx_video.so: videos by libavformat, libavcodec and libswscale.
#include "afx/video_writer_module.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <memory>
#include <mutex>
#include <new>
#include <string>
#include <string_view>
#include <vector>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

namespace {

struct Failure {
  int code;
  std::string text;
};

// What the libraries said last of an error: their return codes alone tell little.
std::mutex said_mutex;
std::array<char, 400> said{};

void keep_message(void* of, int level, const char* format, va_list arguments) {
  if (level > AV_LOG_ERROR) return;
  int prefix = 0;
  const std::lock_guard lock(said_mutex);
  av_log_format_line2(of, level, format, arguments, said.data(), said.size(), &prefix);
}

std::string last_message() {
  const std::lock_guard lock(said_mutex);
  std::string line;
  for (const char* c = said.data(); *c != 0; ++c) line += *c == '\n' || *c == '\r' ? ' ' : *c;
  while (!line.empty() && (line.back() == ' ' || line.back() == '.')) line.pop_back();
  said[0] = 0;
  return line;
}

Failure failure_of(int code, const std::string& what) {
  if (code == AVERROR(ENOMEM)) return {kAfxVideoNoMemory, "the video does not fit into memory"};
  char reason[AV_ERROR_MAX_STRING_SIZE] = {};
  av_strerror(code, reason, sizeof reason);
  const std::string message = last_message();
  return {kAfxVideoRefused, what + ": " + (message.empty() ? reason : message)};
}

void check(int code, const char* what) {
  if (code < 0) throw failure_of(code, what);
}

// Frees what the libraries gave, by functions that take the address of the pointer.
template <class T, void (*free_it)(T**)>
struct Free {
  void operator()(T* pointer) const { free_it(&pointer); }
};
using Codec = std::unique_ptr<AVCodecContext, Free<AVCodecContext, avcodec_free_context>>;
using Frame = std::unique_ptr<AVFrame, Free<AVFrame, av_frame_free>>;
using Packet = std::unique_ptr<AVPacket, Free<AVPacket, av_packet_free>>;
struct FreeFormat {
  void operator()(AVFormatContext* format) const { avformat_free_context(format); }
};
struct FreeScaler {
  void operator()(SwsContext* scaler) const { sws_freeContext(scaler); }
};
struct FreeIo {
  void operator()(AVIOContext* io) const {
    av_freep(&io->buffer);
    avio_context_free(&io);
  }
};

// A file in memory.
struct MemoryFile {
  std::vector<uint8_t> bytes;
  size_t at = 0;
  uint64_t most = 0;
  bool too_long = false;

  int write(const uint8_t* from, size_t size) {
    too_long = too_long || at + size > most;
    if (too_long) return AVERROR(EFBIG);
    try {
      if (at + size > bytes.size()) bytes.resize(at + size);
    } catch (const std::bad_alloc&) {
      return AVERROR(ENOMEM);
    }
    std::memcpy(bytes.data() + at, from, size);
    at += size;
    return static_cast<int>(size);
  }

  int64_t seek(int64_t offset, int whence) {
    const auto size = static_cast<int64_t>(bytes.size());
    if ((whence & AVSEEK_SIZE) != 0) return size;
    whence &= ~AVSEEK_FORCE;
    const int64_t from = whence == SEEK_CUR   ? static_cast<int64_t>(at)
                         : whence == SEEK_END ? size
                                              : 0;
    if (offset + from < 0) return AVERROR(EINVAL);
    at = static_cast<size_t>(offset + from);
    return offset + from;
  }
};

extern "C" int write_to_memory(void* file, uint8_t* bytes, int size) {
  return static_cast<MemoryFile*>(file)->write(bytes, static_cast<size_t>(size));
}

extern "C" int64_t seek_in_memory(void* file, int64_t offset, int whence) {
  return static_cast<MemoryFile*>(file)->seek(offset, whence);
}

// An encoder, the best first, and how it is told the quality.
struct Choice {
  const char* encoder;
  bool webm;           // whether it is what .webm is for
  const char* option;  // for the quality: "crf"; null: by the quantizer; "": it is lossless
  double scale;        // of this quality to that of H.264
  double least, most;
};
constexpr std::array kChoices{
    Choice{"libx264", false, "crf", 1, 0, 51},
    Choice{"libvpx-vp9", true, "crf", 63.0 / 51, 0, 63},
    Choice{"libvpx", true, "crf", 63.0 / 51, 4, 63},
    Choice{"mpeg4", false, nullptr, 1.0 / 6, 1, 31},
    Choice{"ffv1", false, "", 0, 0, 0},
};

AVRational rate_of(double fps) { return av_d2q(fps, 65535); }

void mark_colours(AVCodecContext& codec) {
  codec.color_primaries = AVCOL_PRI_BT709;
  codec.color_trc = AVCOL_TRC_IEC61966_2_1;
  codec.colorspace = AVCOL_SPC_BT709;
  codec.color_range = AVCOL_RANGE_MPEG;
  codec.chroma_sample_location = AVCHROMA_LOC_LEFT;
}

void set_quality(const Choice& choice, int quality, AVCodecContext& codec) {
  const double wanted = std::clamp(quality * choice.scale, choice.least, choice.most);
  if (choice.option == nullptr) {
    codec.flags |= AV_CODEC_FLAG_QSCALE;
    codec.global_quality = static_cast<int>(FF_QP2LAMBDA * wanted);
  } else if (*choice.option != 0) {
    av_opt_set_double(codec.priv_data, choice.option, std::round(wanted), 0);
    if (choice.webm) codec.bit_rate = 0;  // the quality alone decides
  }
}

// An open encoder; null if there is none of that name or it refuses.
Codec open_encoder(const Choice& choice, const afx_video_request& request,
                   const AVOutputFormat& container) {
  const AVCodec* encoder = avcodec_find_encoder_by_name(choice.encoder);
  if (encoder == nullptr ||
      avformat_query_codec(&container, encoder->id, FF_COMPLIANCE_NORMAL) != 1)
    return nullptr;
  Codec codec(avcodec_alloc_context3(encoder));
  if (codec == nullptr) throw std::bad_alloc();
  codec->width = static_cast<int>(request.width);
  codec->height = static_cast<int>(request.height);
  codec->pix_fmt = AV_PIX_FMT_YUV420P;
  codec->framerate = rate_of(request.fps);
  codec->time_base = av_inv_q(codec->framerate);
  codec->sample_aspect_ratio = {1, 1};
  codec->gop_size = static_cast<int>(std::clamp(std::round(request.fps * 2), 1.0, 250.0));
  // AVI has no other times of showing than of decoding.
  codec->max_b_frames = std::strcmp(container.name, "avi") == 0 ? 0 : codec->max_b_frames;
  codec->thread_count = 1;  // the bytes depend on it
  codec->flags |= AV_CODEC_FLAG_BITEXACT;
  if ((container.flags & AVFMT_GLOBALHEADER) != 0) codec->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
  mark_colours(*codec);
  set_quality(choice, request.quality, *codec);
  return avcodec_open2(codec.get(), encoder, nullptr) < 0 ? nullptr : std::move(codec);
}

Codec choose_encoder(const afx_video_request& request, const AVOutputFormat& container) {
  last_message();
  const bool webm = std::strcmp(container.name, "webm") == 0;
  for (const Choice& choice : kChoices) {
    if (choice.webm != webm) continue;
    if (Codec codec = open_encoder(choice, request, container); codec != nullptr) return codec;
  }
  const std::string why = last_message();
  throw Failure{kAfxVideoRefused, std::string("no encoder makes a video for .") + request.format +
                                      " of " + std::to_string(request.width) + " x " +
                                      std::to_string(request.height) + " pixels" +
                                      (why.empty() ? "" : ": " + why)};
}

// RGBA to what the encoder takes: full to narrow range, by the matrix of BT.709.
SwsContext* make_scaler(const AVCodecContext& codec) {
  constexpr int kFlags =
      SWS_BICUBIC | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INP | SWS_FULL_CHR_H_INT | SWS_BITEXACT;
  SwsContext* scaler =
      sws_getContext(codec.width, codec.height, AV_PIX_FMT_RGB0, codec.width, codec.height,
                     codec.pix_fmt, kFlags, nullptr, nullptr, nullptr);
  if (scaler == nullptr) throw Failure{kAfxVideoRefused, "the colours cannot be converted"};
  const int* matrix = sws_getCoefficients(SWS_CS_ITU709);
  sws_setColorspaceDetails(scaler, matrix, 1, matrix, 0, 0, 1 << 16, 1 << 16);
  return scaler;
}

}  // namespace

// The members' order matters: what uses another is freed before it.
struct afx_video {
  explicit afx_video(const afx_video_request& request);
  void add(const uint8_t* rgba);
  void finish();

  MemoryFile file;

 private:
  void open_file(const afx_video_request& request);
  void encode(const AVFrame* picture);
  void check_file(int code);

  std::unique_ptr<AVIOContext, FreeIo> io_;
  std::unique_ptr<AVFormatContext, FreeFormat> format_;
  AVStream* stream_ = nullptr;  // of format_
  Codec codec_;
  std::unique_ptr<SwsContext, FreeScaler> scaler_;
  Frame frame_;
  Packet packet_;
  int64_t next_ = 0;  // number of the picture to come

 public:
  [[nodiscard]] const char* encoder() const { return codec_->codec->name; }
};

afx_video::afx_video(const afx_video_request& request) {
  file.most = request.max_bytes;
  open_file(request);
  scaler_.reset(make_scaler(*codec_));
  frame_.reset(av_frame_alloc());
  packet_.reset(av_packet_alloc());
  if (frame_ == nullptr || packet_ == nullptr) throw std::bad_alloc();
  frame_->format = codec_->pix_fmt;
  frame_->width = codec_->width;
  frame_->height = codec_->height;
  frame_->color_primaries = codec_->color_primaries;
  frame_->color_trc = codec_->color_trc;
  frame_->colorspace = codec_->colorspace;
  frame_->color_range = codec_->color_range;
  check(av_frame_get_buffer(frame_.get(), 0), "the video cannot be made");
}

void afx_video::open_file(const afx_video_request& request) {
  AVFormatContext* format = nullptr;
  const std::string name = std::string("memory.") + request.format;
  check(avformat_alloc_output_context2(&format, nullptr, nullptr, name.c_str()),
        "the kind of video cannot be written");
  format_.reset(format);
  constexpr int kBuffer = 1 << 16;
  auto* buffer = static_cast<unsigned char*>(av_malloc(kBuffer));
  if (buffer == nullptr) throw std::bad_alloc();
  io_.reset(
      avio_alloc_context(buffer, kBuffer, 1, &file, nullptr, write_to_memory, seek_in_memory));
  if (io_ == nullptr) {
    av_free(buffer);
    throw std::bad_alloc();
  }
  format_->pb = io_.get();
  format_->flags |= AVFMT_FLAG_BITEXACT | AVFMT_FLAG_CUSTOM_IO;
  codec_ = choose_encoder(request, *format_->oformat);
  stream_ = avformat_new_stream(format_.get(), nullptr);
  if (stream_ == nullptr) throw std::bad_alloc();
  check(avcodec_parameters_from_context(stream_->codecpar, codec_.get()),
        "the video cannot be made");
  stream_->time_base = codec_->time_base;
  stream_->avg_frame_rate = codec_->framerate;
  stream_->sample_aspect_ratio = codec_->sample_aspect_ratio;
  check_file(avformat_write_header(format_.get(), nullptr));
}

void afx_video::check_file(int code) {
  if (file.too_long)
    throw Failure{kAfxVideoLimit, "the video has more than " + std::to_string(file.most) +
                                      " bytes, which is the limit"};
  check(code, "the video cannot be written");
}

void afx_video::encode(const AVFrame* picture) {
  check(avcodec_send_frame(codec_.get(), picture), "the picture cannot be encoded");
  for (;;) {
    const int code = avcodec_receive_packet(codec_.get(), packet_.get());
    if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
    check(code, "the picture cannot be encoded");
    if (packet_->duration == 0) packet_->duration = 1;  // of one picture
    av_packet_rescale_ts(packet_.get(), codec_->time_base, stream_->time_base);
    packet_->stream_index = stream_->index;
    check_file(av_interleaved_write_frame(format_.get(), packet_.get()));
  }
}

void afx_video::add(const uint8_t* rgba) {
  check(av_frame_make_writable(frame_.get()), "the picture cannot be encoded");
  const int stride = codec_->width * 4;
  sws_scale(scaler_.get(), &rgba, &stride, 0, codec_->height, frame_->data, frame_->linesize);
  frame_->pts = next_++;
  encode(frame_.get());
}

void afx_video::finish() {
  encode(nullptr);
  check_file(av_write_trailer(format_.get()));
  avio_flush(io_.get());
  check_file(io_->error);
}

namespace {

int fail(afx_video_error* error, int code, const std::string& text) {
  error->code = code;
  std::snprintf(error->text, sizeof error->text, "%s", text.c_str());
  return code;
}

// Runs `work`, which throws Failure or std::bad_alloc.
template <class Work>
int guarded(afx_video_error* error, Work&& work) {
  error->code = 0;
  error->text[0] = 0;
  try {
    work();
    return 0;
  } catch (const Failure& failure) {
    return fail(error, failure.code, failure.text);
  } catch (...) {
    return fail(error, kAfxVideoNoMemory, "the video does not fit into memory");
  }
}

afx_video* begin_entry(const afx_video_request* request, afx_video_error* error) {
  afx_video* video = nullptr;
  guarded(error, [&] { video = new afx_video(*request); });
  return video;
}

const char* encoder_entry(const afx_video* video) { return video->encoder(); }

int add_entry(afx_video* video, const uint8_t* rgba, afx_video_error* error) {
  return guarded(error, [&] { video->add(rgba); });
}

int finish_entry(afx_video* video, afx_video_sink sink, void* user, afx_video_error* error) {
  return guarded(error, [&] {
    video->finish();
    if (sink(user, video->file.bytes.data(), video->file.bytes.size()) != 0) throw std::bad_alloc();
  });
}

void close_entry(afx_video* video) { delete video; }

}  // namespace

extern "C" __attribute__((visibility("default"))) const afx_video_module* afx_video_module_get() {
  static const afx_video_module module{
      kAfxVideoModuleVersion, begin_entry, encoder_entry, add_entry, finish_entry, close_entry};
  av_log_set_callback(keep_message);
  return &module;
}
