# docker build -t urdfkit .                              checks and fixes
# docker build -t urdfkit --build-arg EXTRAS=all .       all commands
# docker run --rm -v "$PWD:/robots:ro" urdfkit check .
# docker run --rm -v "$PWD:/robots" --user "$(id -u)" urdfkit fix .
FROM python:3.13-slim AS build
ARG EXTRAS=""
COPY . /source
RUN python -m venv --without-pip /urdfkit \
    && pip --python /urdfkit/bin/python install --no-cache-dir "/source${EXTRAS:+[$EXTRAS]}"

FROM python:3.13-slim
COPY --from=build /urdfkit /urdfkit
ENV PATH=/urdfkit/bin:$PATH
USER nobody
WORKDIR /robots
ENTRYPOINT ["urdfkit"]
CMD ["--help"]
